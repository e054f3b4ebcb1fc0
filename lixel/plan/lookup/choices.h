// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>

// What a technique's lookup is made of: what lixels store, and which of them decide. lookup.h has what they cost.
namespace lixel {

// Which neighbours' depths a lixel keeps beside its own (lixel/shared/lookup/select_depths.h).
enum class DepthSelection : std::uint8_t { Max, Min, MinMax, Sorted };

// One depth, or n of them, of the lixel and its neighbours.
struct DepthStore
{
    int depths = 1;                                 // 1 to 8
    DepthSelection selection = DepthSelection::Max; // n = 2: max or min, 3: minmax, 4 to 8: sorted
    int neighbourhood = 9;                          // q of the paper, the lixel's own among them: 9 or 25
    int bits = 32;                                  // of a depth: 32 for up to four, 16 for four to eight
    friend bool operator==(const DepthStore&, const DepthStore&) = default;
};
// Four neighbouring lixels' depths of 8 bits in one word.
struct FastPcfStore
{
    friend bool operator==(const FastPcfStore&, const FastPcfStore&) = default;
};
// Mean moments of the depths around a lixel.
enum class MomentKind : std::uint8_t { Vsm, Evsm2, Evsm4, Msm };
struct MomentStore
{
    MomentKind kind = MomentKind::Vsm;
    int blur = 3; // lixels of a side, odd, 1 to 15
    friend bool operator==(const MomentStore&, const MomentStore&) = default;
};
using Store = std::variant<DepthStore, FastPcfStore, MomentStore>;

// Taps in a square, results averaged.
enum class PcfGrid : std::uint8_t { Regular, Rotated, Jittered };
struct PcfKernel
{
    int taps = 1; // k of the papers: 1, 4, 9, 16 or 25, one lixel apart
    PcfGrid grid = PcfGrid::Regular;
    friend bool operator==(const PcfKernel&, const PcfKernel&) = default;
};
// The four lixels around by their areas, rounded.
struct BilinearKernel
{
    friend bool operator==(const BilinearKernel&, const BilinearKernel&) = default;
};
// The same not rounded, by the texture unit.
struct HardwarePcfKernel
{
    friend bool operator==(const HardwarePcfKernel&, const HardwarePcfKernel&) = default;
};
using Kernel = std::variant<PcfKernel, BilinearKernel, HardwarePcfKernel>;

} // namespace lixel
