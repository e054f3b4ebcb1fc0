// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/observation.h"
#include "lixel/base/plane.h"
#include "lixel/base/view.h"
#include "lixel/base/view_samples.h"
#include "lixel/plan/allocate.h"
#include "lixel/plan/fit/fit.h"
#include "lixel/plan/light_image.h"
#include "lixel/plan/lookup/lookup.h"
#include "lixel/plan/partition/find_planes.h"
#include "lixel/plan/technique.h"
#include "lixel/plan/warp/texture_warp.h"
#include "lixel/shared/shadow_tables.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

// From a view, lights and bounds to everything an executor needs. Pure: no I/O, no state, no exceptions.
namespace lixel {

// Another engine's map: scored as it is, with neither crop nor guard band.
struct GivenRegion
{
    Mat4d lightClipFromWorld;                // lixel's convention (fromHost)
    std::optional<LixelRectangle> rectangle; // of its layer; plan(file) has them
    CellPlanes halfSpacesWorld;
};
struct GivenLight
{
    std::string light; // its name; empty: any
    std::vector<GivenRegion> regions;
};

// What plans of a light hand on to the next frame's, whose originWorld is the same.
struct RememberedPlane
{
    Plane planeLocal;
    bool hadRegion = false;
};
struct LightMemory
{
    std::vector<RememberedPlane>
        planes; // that planes(auto) found: they keep their very places, and, while it does not cost, their maps
    std::vector<RememberedMap> maps; // of the regions, in their order
};

struct PlanInput
{
    View view;
    std::span<const Light> lights;
    std::span<const Box> casterBoxesWorld; // conservative bounds of all casters and receivers
    Vec3d originWorld;                     // what floats are counted from; near the eye
    MapTechnique technique;
    LixelSize lixels; // the budget of each light
    // What the view sees, for techniques made from it (needsViewSamples) and to predict errors by; same originWorld. Receivers
    // that are not in the list may lie outside maps made from it.
    const ViewSamples* seen = nullptr;
    bool seenIsAll =
        false; // it lists every receiver that will be asked: an else(...) that none of them needs has no map
    std::span<const LixelSize> lixelsOfRegions =
        {}; // in the order of regions, in place of `lixels`, where there are as many and no first pass was drawn
    std::span<const GivenLight> given = {};  // for matrix(file) and plan(file)
    std::span<const NamedPlane> planes = {}; // that planes(...) may name
    // Where shadows end, as a first pass or an earlier frame saw it: shares and choices are made by it, else by `seen`.
    const Observation* observed = nullptr;
    // What each light sees through each of its maps (lightViewOf), for warps by forward analysis; an entry a light; same
    // originWorld.
    std::span<const std::vector<ViewSamples>> seenByLights = {};
    // Spent of each light's lixels before this plan, on the first pass that observed.
    std::int64_t lixelsSpent = 0;
    std::span<const LightMemory> before = {}; // an entry a light (rememberedBy); empty: nothing was before
};

// One map: a region's projection and its place.
struct PlannedRegion
{
    Mat4d lightClipFromLocal; // lixel's convention; its NDC square is the whole rectangle
    LixelRectangle rectangle;
    CellPlanes halfSpacesLocal = {}; // what it asks of receivers that regions before it do not serve
    Vec2d guard{};                   // lixels at the rectangle's borders that serve no one: a later region does
    int plane = -1;                  // of a plane's region: which of PlanInput::planes, or of planes(auto) those found
    bool isInDouble = false;         // floats of the matrix would move its lixels visibly
    std::optional<PixelRectangle> pixels = {}; // of a map with a lixel a pixel: those, its guard band not among them
    std::optional<Plane> pixelPlaneLocal = {}; // of such a map: the plane, its unit normal towards the light
    RememberedMap fit = {};                    // that was placed here, for the next frame
    TextureWarp warp = {};                     // after the matrix
    std::optional<Paraboloid> paraboloid = {}; // after the matrix, and before the warp

    LightProjection projection() const { return {lightClipFromLocal, paraboloid}; }
};

// What was decided for one light.
struct ShadowPlan
{
    std::vector<PlannedRegion> regions; // in the order they serve; empty where refused
    std::optional<FitFailure> refused;

    std::vector<FoundPlane> foundPlanes; // by planes(auto), heaviest first; those with regions are the ones that pay
    std::vector<LeftOutPlane> leftOut;   // an else(...) serves what is seen of them; `plane` as in PlannedRegion
};

// Layout (known before the frame is drawn) and tables (what shaders read).
struct FramePlan
{
    LixelSize atlas; // of each layer
    int layers = 0;
    LookupLayout lookup;
    Vec3d originWorld;
    std::vector<ShadowPlan> lights; // one a light, in the input's order
    std::int64_t lixelsSpent = 0;   // of each light, on a first pass

    std::vector<shared::ShadowRegion> regionTable;
    std::vector<shared::vec4> halfSpaceTable; // xyz, w: inside where dot(xyz, pointLocal) + w >= 0
    std::vector<shared::ShadowLight> lightTable;
    std::vector<float> warpTable; // knots of all warps (lixel/shared/warp.h)

    std::int64_t lixelsOf(std::size_t light) const; // every lixel allocated for it
};

// For the plan of the next frame.
std::vector<LightMemory> rememberedBy(const FramePlan& plan);

// What a technique wants drawn and observed before its plan, where no earlier frame tells where shadows end.
struct FirstPass
{
    MapTechnique technique;
    LixelSize lixels;     // of each light; they count
    ObservationGrid grid; // that it is observed by
};
std::optional<FirstPass> firstPassOf(const MapTechnique& technique, LixelSize lixels);

// `recycled` is an earlier plan whose storage is used again: with it and the same scratch, a frame like the last one allocates
// nothing.
FramePlan planShadows(const PlanInput& input, FitScratch& scratch, FramePlan recycled = {});
FramePlan planShadows(const PlanInput& input);

// One matrix as shaders read it: rounded to float, columns.
shared::mat4 toShared(const Mat4d& matrix);

} // namespace lixel
