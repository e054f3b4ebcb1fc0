// SPDX-License-Identifier: MIT
#pragma once

#include "comparison.h"
#include "lixel/judge/temporal.h"
#include "lixel/plan/shadow_plan.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace lixel::app {

// What stays known of a light in the frame before.
struct TruthBefore
{
    std::span<const ShadowState> exact;
    std::span<const Zone> zones;
};

// One row of the results while the frames of a path are added to it: of one technique, executor and light.
class PathRow
{
public:
    PathRow() = default;
    explicit PathRow(ResultRow key) : row_(std::move(key)) {}

    // For each frame: begin it, and then either its refusal, or all that was measured in it.
    void beginFrame(double seconds);
    void addRefusal(FitFailure reason);
    void add(const Measurement& counts);
    void addMap(std::int64_t lixels, std::int64_t bytesPerLixel);
    void add(const Density& density);
    void add(const ExecutorAgreement& counts, const LixelAgreement& lixels);

    // Of the samples carried `from` the frame before; nothing where that was refused.
    void addFlips(const TruthBefore& before, std::span<const std::uint32_t> from, std::span<const ShadowState> map,
                  std::span<const ShadowState> exact);
    void keepStates(std::vector<ShadowState> ofSamples); // for the frame that follows

    void show(const PictureFiles& pictures, const RowTiming& timing);

    // `other`: the executor that agreement was counted with, or empty.
    ResultRow finished(bool isStill, std::string_view other);

private:
    ResultRow row_;
    Measurement sum_;
    Temporal temporal_;
    ExecutorAgreement agreement_;
    LixelAgreement lixels_;
    std::vector<double> pixelsPerLixel_, lixelsPerPixel_;
    std::optional<std::vector<ShadowState>> states_; // of the frame before; none where it was refused
    std::optional<FitFailure> refused_;              // the last reason
};

} // namespace lixel::app
