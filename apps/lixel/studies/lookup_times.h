// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/lookups.h"
#include "one_light.h"
#include "progress.h"

#include <string>
#include <vector>

// What frames with each lookup take, over frames with one depth and one tap, in rounds of all of them.
namespace lixel::app {

class LookupTimes
{
public:
    // `frames` of each lookup and picture.
    LookupTimes(std::vector<TechniqueChoice> lookups, LixelSize lixels, int frames)
        : lookups_(std::move(lookups)), lixels_(lixels), frames_(frames), sums_(lookups_.size())
    {
    }

    // Under all lights of the shot; the first lookup is what the others stand beside. False, and nothing done, where one is refused.
    bool add(const StudiedPicture& picture, const Shot& shot, Progress& progress);

    // Of lookup `i`; nothing before a picture is added.
    std::optional<LookupStudy::Times> of(std::size_t i) const;

private:
    struct Sum
    {
        double logFrameRatio = 0, logPassRatio = 0, prepareMs = 0, lookupMs = 0;
    };
    std::vector<TechniqueChoice> lookups_;
    LixelSize lixels_;
    int frames_;
    std::vector<Sum> sums_;
    int pictures_ = 0;
};

} // namespace lixel::app
