// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/convex.h"
#include "lixel/base/expected.h"
#include "lixel/base/light.h"
#include "lixel/base/rectangle.h"
#include "lixel/base/view.h"
#include "lixel/plan/boundary_directions.h"
#include "lixel/plan/fit/edge_rays.h"
#include "lixel/plan/fit/need_sample.h"
#include "lixel/plan/light_projection.h"
#include "lixel/plan/partition/find_planes.h"
#include "lixel/plan/warp/warp_scratch.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

// What every fit takes and gives. A fit is the projection of one region: Local space to the light's NDC square and a depth.
namespace lixel {

// Why a plan says no. Reports show the name and the sentence.
enum class FitFailure {
    NothingInView,         // no part of the scene is in the view and in the light's reach: there is nothing to shadow
    ExtentNotInHemisphere, // what must be seen from the light does not fit one perspective map; `cube` is needed
    EmptyScene,            // there are no casters
    NoViewSamples,         // the fit or partition is made from view samples, and none were given
    NotGiven,              // the file of matrix(file) or plan(file) has nothing for this light
    TooFewLixels,          // the budget has less than one lixel for each region, or than a lixel a pixel
    NoSuchPlane,           // planes(...) names a plane that is not there
    PlaneFacesAway,        // the plane is between the eye and the light: nothing seen of it faces the light
    LightInPlane,          // the light lies in the plane: its rays do not cross it
    EyeInPlane,            // the plane is seen edge-on
    NoPlaceOfLight,        // the light is directional, and the partition needs one with a place
};
std::string_view nameOf(FitFailure failure);
std::string_view sentenceFor(FitFailure failure);

// A convex set of light rays (light_rays.h): a spherical polygon, its corners in order.
inline constexpr std::size_t kMostRayCorners = 40;
using RayPolygon = FixedVector<Vec3d, kMostRayCorners>;

// A plane of interest that has no region, and why.
struct LeftOutPlane
{
    int plane = -1;
    FitFailure why = FitFailure::NothingInView;
};

// Room that fits work in. The same one again and again allocates nothing after the first frames.
struct FitScratch
{
    struct OnPlane
    {
        std::vector<Vec2d> points, hull;
        std::vector<NumberedPoint> numbered, numberedHull;
    };
    std::vector<Vec3d> points, corners, casterPoints, directions;
    OnPlane plane;
    struct OfScene // scene_optimal.h
    {
        EdgeRays all, some;
        std::vector<Vec3d> corners, bodyCorners;
        std::vector<Vec2d> image;
        std::vector<double> values;
        std::vector<NeedSample> edges, edgesInCell;
        std::vector<Vec3d> shadowsLocal, shadowsInCell;
    };
    OfScene scene;
    // View samples that face the light, those of them that no region serves yet, and those of a region.
    std::vector<Vec3d> seenLocal, seenNormal, seenUnservedLocal, seenInCellLocal;
    std::vector<RayPolygon> rays, raysRoom;         // those that no region serves yet
    std::vector<Vec3d> pointsOfRays, cornersOfRays; // what those rays were found from
    std::vector<NeedSample> need;
    BoundaryDirections boundaryDirections;
    std::vector<Vec3d> needLocal; // where they are
    PlaneScratch planes;
    std::vector<Plane> earlierPlanes;
    std::vector<Vec3d> planePoints, planeNormals; // of what planes are sought among
    std::vector<float> planeWeights;
    std::vector<LeftOutPlane> leftOut;
    RegionWarpScratch warps;
};

// Half-spaces of a region, Local, inside positive.
using CellPlanes = FixedVector<Plane, 16>;

// How the rectangle of a plane's lixels lies on the picture (plane_optimal.h).
enum class Twist : std::uint8_t {
    None,  // along the pixels: lixels are axis-aligned rectangles on the picture
    Tight, // the rectangle of least area: lixels are rotated rectangles
    Line   // along the line where the plane meets the next one
};

// The plane that a region is for.
struct PlaneOfCell
{
    Plane planeLocal; // unit normal, either way
    Twist twist = Twist::Tight;
    std::optional<Plane> throughLineLocal = {}; // for Twist::Line: the plane through the light and that line
};

// Whole pixels x0 <= x < x1, y0 <= y < y1 of the picture; they may lie beyond its borders.
struct PixelRectangle
{
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    friend bool operator==(const PixelRectangle&, const PixelRectangle&) = default;
};

// A region's fit of the frame before.
struct RememberedMap
{
    Mat4d lightClipFromLocal; // before it was placed
    Vec4d lightWorld;         // homogeneousWorld()
    int framesKept = 0;       // Fit's
    double rounding = 0;      // Fit's
};

struct FramedBody; // light_frame.h

struct FitInput
{
    const View& view;
    const Light& light;
    Vec3d originWorld; // Local = World - originWorld
    std::span<const Box> casterBoxesWorld;
    Box sceneLocal; // of all casters and receivers
    FitScratch& scratch;
    CellPlanes cellLocal{};                   // receivers outside are not this region's; none: all of space
    bool hasViewSamples = false;              // whether view samples were given at all ...
    std::span<const Vec3d> seenLocal = {};    // ... and those of this region that face the light
    bool isStable = false;                    // the map must not crawl as the camera moves
    std::optional<PlaneOfCell> plane = {};    // of a region that is for a plane
    bool wantsWholePixels = false;            // a lixel a pixel, where the fit can
    bool seenIsAll = false;                   // the view samples are all receivers that will be asked
    std::span<const NeedSample> edges = {};   // of this region, near shadow boundaries (scene_optimal.h)
    std::span<const Vec3d> shadowsLocal = {}; // receivers of this region that were observed in shadow or near its edge
    const RememberedMap* before = nullptr;    // what this region had in the last frame
    double mapAspect = 1;                     // lixels across the map over those along it, as far as that is known
    const FramedBody* visible = nullptr;      // what visibleBody() gives without a cell, where that is known already
};

// Needs nothing of the map's size. lightClipFromLocal is in lixel's convention (clip_convention.h): receivers that matter
// lie in NDC x, y in [-1, +1], z <= +1; casters in front of z = -1 are clamped to it.
struct Fit
{
    Mat4d lightClipFromLocal;
    bool snapsToWorld = false; // parallel and of constant size: its lixels are to keep their places in the world

    // What of its region it holds. All that may be seen, but for a fit made from view samples; within these half-spaces through
    // the light, where it is narrowed to some rays.
    bool isOfSamples = false;
    CellPlanes holdsLocal{};
    std::optional<Plane> narrowedToLocal =
        {}; // receivers outside are too near to the light for this map: the next region's

    int framesKept = 0; // since it was last asked for anew, of what FitInput::before had

    std::optional<PixelRectangle> pixels = {}; // the NDC square is this part of the picture, at a lixel a pixel

    std::optional<Paraboloid> paraboloid = {}; // in place of the division by w
    LightProjection projection() const { return {lightClipFromLocal, paraboloid}; }

    // Of half its size: what floats of the matrix may move a receiver by, for fits that do not see to it themselves.
    double rounding = 0;
};

// Whether floats of the matrix would move lixels by more than 1/256 of one, a rasterizer's own step, in a map of this size.
inline bool needsDouble(const Fit& fit, int width, int height)
{
    return fit.rounding * 0.5 * std::max(width, height) > 1.0 / 256;
}

using FitResult = Expected<Fit, FitFailure>;

} // namespace lixel
