// SPDX-License-Identifier: MIT
#pragma once

#include "comparison.h"
#include "experiments/now_settings.h"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace lixel::app {

// What one method came to in one scene: over its pictures that every method serves.
struct NowOutcome
{
    double misclassified = 0, lightFacing = 0; // samples
    double frameMs = 0, planMs = 0;            // sums over pictures
    std::map<std::string, double> passMs;      // likewise
    double percent() const { return lightFacing > 0 ? 100 * misclassified / lightFacing : 0; }
    double wholeMs() const { return frameMs + planMs; }
};
using NowOutcomes = std::array<NowOutcome, kNowMethods.size()>;

// The methods beside each other, picture by picture, in one run.
class NowRace
{
public:
    explicit NowRace(const ExperimentOptions& options);

    // Scenes in the paper's order, or those of some names in it only.
    void run(std::span<const char* const> paperNames = {});

    const std::vector<NowScene>& scenes() const { return scenes_; }
    const NowOutcomes& of(const NowScene& scene) const { return outcomes_.at(scene.paperName); }
    // Shadow volumes, the paper's SV, over the same pictures; null where some picture refuses them.
    const NowOutcome* volumesOf(const NowScene& scene) const;
    bool has(const NowScene& scene) const { return outcomes_.count(scene.paperName) > 0; }

    // Rows, figures, parameters and the host; numbers are the experiment's.
    Reproduction finished();

private:
    void addPicture(const NowScene& scene, const PictureOptions& picture, std::size_t number);

    const ExperimentOptions& options_;
    std::string leftOut_;
    std::vector<NowScene> scenes_;
    std::vector<std::unique_ptr<Executor>> executors_;
    ComparisonOptions comparison_;
    std::map<std::string, NowOutcomes> outcomes_;
    std::map<std::string, NowOutcome> volumes_;
    std::set<std::string> withoutVolumes_; // scenes
    int refusedPictures_ = 0;
    Reproduction out_;
};

} // namespace lixel::app
