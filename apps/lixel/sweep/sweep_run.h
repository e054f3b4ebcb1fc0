// SPDX-License-Identifier: MIT
#pragma once

#include "executor.h"
#include "sweep/row_log.h"
#include "sweep/sweep_plan.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lixel::app {

// Measures cells of a sweep, one after the other. What neighbours have in common stays until a cell has another: the scene,
// its search structure, a picture's view samples, and with its lights their exact visibility.
class SweepRun
{
public:
    SweepRun(const SweepFile& file, const SweepPlan& plan, SceneShelf& shelf);
    ~SweepRun();

    // The lines of its rows, one a light. Throws InputError where the scene no longer has the view, and what measuring throws.
    std::vector<std::string> measure(const SweepCell& cell);
    std::string host() const { return executors_.front()->host(); }

private:
    struct Picture;
    struct Lit;
    Lit& litFor(const SweepGroup& group);

    const SweepFile& file_;
    const SweepPlan& plan_;
    SceneShelf& shelf_;
    std::vector<std::unique_ptr<Executor>> executors_; // one
    std::unique_ptr<Picture> picture_;
    std::unique_ptr<Lit> lit_;
};

} // namespace lixel::app
