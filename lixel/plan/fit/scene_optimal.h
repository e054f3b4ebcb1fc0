// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/fit.h"
#include "lixel/plan/fit/lixel_energy.h"
#include "lixel/plan/fit/map_search.h"

namespace lixel {

// What the map must hold.
enum class MapExtent : std::uint8_t {
    Seen,   // all receivers
    Shadows // those in shadow and those near its edges, as they were observed: what was lit all around goes to else(...)
};

enum class MapSearchKind : std::uint8_t {
    Wide,   // all axes (searchWidely)
    Descent // the paper's Algorithm 1
};

// The light image that is best for what is seen, by an energy of the samples near shadow boundaries.
struct SceneOptimalFit
{
    LixelMetric metric = LixelMetric::Width;
    MapSearchKind search = MapSearchKind::Wide;
    MapExtent extent = MapExtent::Shadows;
    int iterations = 3; // of the descent
    bool hasShear = false;
    double slack = 0.02;           // the rectangle is larger by this part, where only some receivers are known
    double awayFromBoundaries = 0; // weight of samples there, against 1
    int samples = 180;             // of an observation's grid, each way
    double keep = 0.8; // of an earlier map's median badness: a new one takes its place below that; none: infinite
    int update = 3;    // a new one is looked for every so many frames
    bool uncoveredIsLit = false; // as the paper's single map: nothing serves what falls out

    friend bool operator==(const SceneOptimalFit&, const SceneOptimalFit&) = default;
};

// Holds the view samples of the region, at the least energy of FitInput::edges.
//
//   H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007.
//
//   Needs    view samples, and those of them near shadow boundaries: without any, the rectangle of least area
//   Returns  never a worse map, by its own metric, than desired-view(rotated), lispsm, psm and tsm give (search=wide)
//   Before   FitInput::before is kept until a new map's median badness is clearly below its (section 2.3, step 5): as it is while
//            it holds what it must with little to spare, else with the scale and shift that do
//   Refuses  EmptyScene, NoViewSamples, NothingInView, ExtentNotInHemisphere
//   Differs  parallel light has its place across the light, scaled to [-1, 1], for a direction (the paper leaves it out); the metric is a
//            parameter, and the paper's is not the default; so is the search, whose default is not the paper's
//   Angles   of the descent (search=paper)
FitResult fitSceneOptimal(const FitInput& input, const SceneOptimalFit& choice,
                          std::span<const double> angles = kPaperAngles);

// Whether the fit looks for a new map after this one; until then it needs no FitInput::edges.
inline bool isNewMapDueAfter(const RememberedMap& before, const SceneOptimalFit& choice)
{
    return before.framesKept + 1 >= choice.update;
}

// What the search of an input is asked, in a frame of its light; all of it lies in the input's scratch and in the frame's light plane.
// Nothing where no sample says anything, or where all is in line.
struct SceneQuestion
{
    LightFrame frame;
    std::optional<MapQuestion> map;
};
Expected<SceneQuestion, FitFailure> sceneQuestion(const FitInput& input, const SceneOptimalFit& choice);

// The light image's rows in a frame of its light, of one lixel: what energies are asked of. Nothing of frames without extent.
std::optional<PlaneWarp> planeWarpOf(const LightFrame& frame, const Mat4d& lightClipFromLocal);

} // namespace lixel
