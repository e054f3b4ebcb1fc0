// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/convex.h"
#include "lixel/base/expected.h"
#include "lixel/base/light.h"
#include "lixel/base/view.h"

#include <span>
#include <string_view>
#include <vector>

// What every fit takes and gives. A fit is the projection of one region: Local space to the light's NDC square and a depth.
namespace lixel {

// Why a fit says no. Reports show the name and the sentence.
enum class FitFailure {
    NothingInView,         // no part of the scene is in the view and in the light's reach: there is nothing to shadow
    ExtentNotInHemisphere, // what must be seen from the light does not fit one perspective map; `cube` is needed
    EmptyScene,            // there are no casters
};
std::string_view nameOf(FitFailure failure);
std::string_view sentenceFor(FitFailure failure);

// Room that fits work in. The same one again and again allocates nothing after the first frames.
struct FitScratch
{
    std::vector<Vec3d> points;
    std::vector<Vec2d> onPlane, hull;
};

struct FitInput
{
    const View& view;
    const Light& light;
    Vec3d originWorld; // Local = World - originWorld
    std::span<const Box> casterBoxesWorld;
    Box sceneLocal; // of all casters and receivers
    FitScratch& scratch;
};

// Needs nothing of the map's size. lightClipFromLocal is in lixel's convention (clip_convention.h): receivers that matter
// lie in NDC x, y in [-1, +1], z <= +1; casters in front of z = -1 are clamped to it.
struct Fit
{
    Mat4d lightClipFromLocal;
};

using FitResult = Expected<Fit, FitFailure>;

} // namespace lixel
