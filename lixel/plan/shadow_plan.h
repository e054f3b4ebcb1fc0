// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/view.h"
#include "lixel/plan/fit/fit.h"
#include "lixel/plan/light_image.h"
#include "lixel/plan/lookup/lookup.h"
#include "lixel/plan/technique.h"
#include "lixel/shared/shadow_tables.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// From a view, lights and bounds to everything an executor needs. Pure: no I/O, no state, no exceptions.
namespace lixel {

// Lixels a light may use in a frame. One size is a total; with several they are the maps themselves.
struct LixelSize
{
    int width = 0, height = 0;
    friend bool operator==(const LixelSize&, const LixelSize&) = default;
};

struct PlanInput
{
    View view;
    std::span<const Light> lights;
    std::span<const Box> casterBoxesWorld; // conservative bounds of all casters and receivers
    Vec3d originWorld;                     // what floats are counted from; near the eye
    MapTechnique technique;
    LixelSize lixels; // the budget of each light
};

// One map: a region's projection and its place.
struct PlannedRegion
{
    Mat4d lightClipFromLocal; // lixel's convention; its NDC square is the whole rectangle
    LixelRectangle rectangle;
};

// What was decided for one light.
struct ShadowPlan
{
    std::vector<PlannedRegion> regions; // in the order they serve; empty where refused
    std::optional<FitFailure> refused;
};

// Layout (known before the frame is drawn) and tables (what shaders read).
struct FramePlan
{
    LixelSize atlas; // of each layer
    int layers = 0;
    LookupLayout lookup;
    Vec3d originWorld;
    std::vector<ShadowPlan> lights; // one a light, in the input's order

    std::vector<shared::ShadowRegion> regionTable;
    std::vector<shared::vec4> halfSpaceTable; // xyz, w: inside where dot(xyz, pointLocal) + w >= 0
    std::vector<shared::ShadowLight> lightTable;

    std::int64_t lixelsOf(std::size_t light) const; // every lixel allocated for it
};

// `recycled` is an earlier plan whose storage is used again: with it and the same scratch, a frame like the last one allocates
// nothing.
FramePlan planShadows(const PlanInput& input, FitScratch& scratch, FramePlan recycled = {});
FramePlan planShadows(const PlanInput& input);

// One matrix as shaders read it: rounded to float, columns.
shared::mat4 toShared(const Mat4d& matrix);

} // namespace lixel
