// SPDX-License-Identifier: MIT
#include "studies/lookup_times.h"

#include "lixel/base/median.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

namespace lixel::app {
namespace {

double msOf(const RowTiming& timing, std::string_view pass)
{
    const auto found = std::ranges::find(timing.passes, pass, &PassTime::name);
    return found != timing.passes.end() ? found->ms : 0;
}

// One frame and its passes. Where processors draw, frames are what they spend on them: that depends little on what else the machine does.
struct Frame
{
    double cost = 0, prepareMs = 0, lookupMs = 0;
};

Frame timed(const StudiedPicture& picture, const FramePlan& plan)
{
    const std::clock_t began = std::clock();
    const RowTiming timing = picture.executor.time(picture.stage, plan, picture.view, 1);
    const double spent = double(std::clock() - began);
    return {timing.gpuMs ? *timing.frameMs : spent, msOf(timing, "prepare"), msOf(timing, "lookup")};
}

// Of one lookup: costs over those of the first, and the least times of passes.
struct Rounds
{
    std::vector<double> frameRatio;
    double prepareMs = 1e30, lookupMs = 1e30;

    void add(const Frame& frame, const Frame& nearest)
    {
        frameRatio.push_back(frame.cost / nearest.cost);
        prepareMs = std::min(prepareMs, frame.prepareMs);
        lookupMs = std::min(lookupMs, frame.lookupMs);
    }
};

} // namespace

bool LookupTimes::add(const StudiedPicture& picture, const Shot& shot, Progress& progress)
{
    const PlanSubject subject{picture.stage, picture.view, shot.lights, picture.shooting.planes, picture.samples};
    LixelBudget budget;
    budget.total = lixels_;
    std::vector<FramePlan> plans;
    for (const TechniqueChoice& lookup : lookups_) {
        plans.push_back(*planFor(lookup, subject, budget, picture.executor));
        if (std::ranges::any_of(plans.back().lights, [](const ShadowPlan& plan) { return plan.refused.has_value(); }))
            return false;
    }
    std::vector<Rounds> rounds(plans.size());
    for (int round = 0; round < frames_; ++round) {
        progress.step(fmt::format("{}: frames, round {} of {}", shot.name, round + 1, frames_));
        const Frame nearest = timed(picture, plans.front());
        for (std::size_t i = 0; i < plans.size(); ++i) rounds[i].add(timed(picture, plans[i]), nearest);
    }
    for (std::size_t i = 0; i < plans.size(); ++i) {
        const double passes = rounds[i].prepareMs + rounds[i].lookupMs;
        sums_[i].logFrameRatio += std::log(median(rounds[i].frameRatio));
        sums_[i].logPassRatio += std::log(passes / rounds.front().lookupMs);
        sums_[i].prepareMs += rounds[i].prepareMs;
        sums_[i].lookupMs += rounds[i].lookupMs;
    }
    ++pictures_;
    return true;
}

std::optional<LookupStudy::Times> LookupTimes::of(std::size_t i) const
{
    if (pictures_ == 0) return std::nullopt;
    const Sum& sum = sums_[i];
    return LookupStudy::Times{std::exp(sum.logFrameRatio / pictures_), std::exp(sum.logPassRatio / pictures_),
                              sum.prepareMs / pictures_, sum.lookupMs / pictures_};
}

} // namespace lixel::app
