// SPDX-License-Identifier: MIT
#pragma once

#include "bench/bench_axes.h"
#include "executor.h"
#include "picture_options.h"
#include "shadows.h"

#include <optional>
#include <string>

namespace lixel::app {

// A point of an axis, made ready for all techniques: the scene, its view and lights. For `gl` there is no search structure, as nothing asks
// for exact visibility.
class BenchStage
{
public:
    BenchStage(const BenchPoint& point, const std::string& executor);

    std::uint64_t triangles() const { return std::uint64_t(stage_.buffers.triangles.triangleCount()); }

    // By an executor of its own, so that no other technique's memory is in it. Why not, where it cannot be.
    struct Outcome
    {
        std::optional<BenchRow::Measured> measured;
        std::string whyNot;
    };
    Outcome measure(const TechniqueChoice& technique, int frames) const;

private:
    BenchPoint point_;
    std::string executor_;
    Shooting shooting_;
    Shot shot_;
    Stage stage_;
    View view_;
};

} // namespace lixel::app
