// SPDX-License-Identifier: MIT
#pragma once

#include "experiment.h"
#include "picture_options.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// What the experiments of Milet et al. 2015 look at: two interiors and an outdoor scene, in place of the paper's Observatory, which
// nobody has, our city. The paper gives no place of its camera or lights.
namespace lixel::app {

// The paper's ways to make a map, its section 4, and what it says of each.
struct NowMethod
{
    const char* title;     // in the paper
    const char* technique; // ours for it
    double tableOneMs;     // a frame on Observatory, Table 1; 0 where it has none
};
inline constexpr std::array<NowMethod, 6> kNowMethods{{{"SM", "uniform", 1.596},
                                                       {"MIN-SM", "paper:min-sm", 1.7},
                                                       {"RTW", "paper:rtw", 3.296},
                                                       {"Ours", "paper:now", 4.708},
                                                       {"Ours-DV", "paper:now-dv", 2.521},
                                                       {"NOW of lixel", "desired-view(rotated)+now", 0}}};
enum NowMethodIndex : std::size_t { NowSm, NowMinSm, NowRtw, NowOurs, NowOursDv, NowOfLixel };

struct NowScene
{
    const char* paperName;
    std::string file; // built-in name, or path
    std::vector<PictureOptions> pictures;

    std::string title() const { return std::filesystem::path(file).stem().string(); }
};

// Those there are: files are looked for in the experiment's folder of scenes. `leftOut` says which are not there.
std::vector<NowScene> nowScenes(const ExperimentOptions& options, std::string& leftOut);

} // namespace lixel::app
