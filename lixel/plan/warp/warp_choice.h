// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/warp/texture_warp.h"

#include <cstdint>
#include <variant>

// What a technique says of its texture warp.
namespace lixel {

// Weights of a sample, each within [0, 1] (lixel/shared/importance.h has what they are); a set of them is a sum of these.
enum SampleWeight : std::uint8_t {
    kDistanceWeight = 1,    // to the eye: the nearest sample's distance over this one's
    kNormalWeight = 2,      // more, the more straight it faces the eye and the less the light
    kEdgesWeight = 4,       // at edges of surfaces in the picture
    kBoundariesWeight = 8,  // near the edges of shadows, as a first pass or an earlier frame saw them
    kShadowEdgesWeight = 16 // at edges of what the light sees; of samples that the light sees
};

// What lixels are given for: a product of weights, of the greatest of some weights, and of the number of samples.
struct Importance
{
    bool isCounted = true; // a lixel sums up its samples; else it has what is greatest among them
    std::uint8_t factors = kEdgesWeight, greatestOf = 0;

    bool has(SampleWeight weight) const { return ((factors | greatestOf) & weight) != 0; }
    friend bool operator==(const Importance&, const Importance&) = default;
};

// Whose samples are counted.
enum class Analysis {
    Backward, // the view's
    Forward,  // those that the light sees, through the map as it is without the warp
    Hybrid    // both
};

// Common to both warps. Defaults are what had the fewest errors over scenes and views (docs/results.md), rtw's its own.
struct WarpOptions
{
    Importance importance = {};
    Analysis analysis = Analysis::Backward;
    double power = 2.0 / 3;   // density goes with importance to this power
    double smooth = 1.0 / 16; // lines (in rtw cells) within this share of all of them on either side count too
    double floor = 0.02;      // of the density, as a share of its mean along a line
    int grid = 512;           // cells a side at most; never more than lixels
    WarpRaster raster = WarpRaster::Exact;
    friend bool operator==(const WarpOptions&, const WarpOptions&) = default;
};

struct NoWarp
{
    friend bool operator==(const NoWarp&, const NoWarp&) = default;
};
struct RtwWarp
{
    WarpOptions options{.power = 1, .smooth = 1.0 / 64};
    friend bool operator==(const RtwWarp&, const RtwWarp&) = default;
};
struct NowWarp
{
    WarpOptions options;
    WarpLines lines = WarpLines::Interpolated;
    friend bool operator==(const NowWarp&, const NowWarp&) = default;
};
using WarpChoice = std::variant<NoWarp, RtwWarp, NowWarp>;

// Of either warp; null without one.
inline const WarpOptions* warpOptionsOf(const WarpChoice& choice)
{
    if (const auto* rtw = std::get_if<RtwWarp>(&choice)) return &rtw->options;
    if (const auto* now = std::get_if<NowWarp>(&choice)) return &now->options;
    return nullptr;
}

} // namespace lixel
