// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/light_rays.h"
#include "lixel/plan/need.h"
#include "lixel/plan/partition/planes.h"
#include "lixel/plan/shadow_plan.h"

#include <optional>
#include <vector>

namespace lixel {

// The plan of one light, station by station: cells, a fit in each, what serves the rest, lixels for each, each in its place.
class LightPlanner
{
public:
    // The light is one of the input's; scratch.need has its samples (gatherNeedSamples).
    LightPlanner(const PlanInput& input, std::size_t number, const Box& sceneLocal, FitScratch& scratch);

    // What was refused, if anything; then nothing of the light is served.
    std::optional<FitFailure> choose(ShadowPlan& out);

    // Into rectangles of one layer; `atlas` grows to hold them. False where there are too few lixels.
    bool placeAll(int layer, const LookupLayout& lookup, LixelSize& atlas, std::vector<PlannedRegion>& regions);

private:
    // One region before it has lixels.
    struct Candidate
    {
        Fit fit;
        CellPlanes halfSpacesLocal; // asked of receivers
        int plane = -1;
        Need need;
        std::optional<Plane> pixelPlaneLocal; // of a map with a lixel a pixel
    };
    using Candidates = FixedVector<Candidate, 2 * kMostCells>;

    std::optional<FitFailure> tryPlanes(const InterestPlanes& planes, Twist twist, std::vector<LeftOutPlane>& leftOut);
    void lookForPlanes(std::vector<FoundPlane>& found);
    InterestPlanes planesThatPay(std::span<const FoundPlane> found, Twist twist);
    void keepThoseThatPay(InterestPlanes& chosen, Twist twist);
    bool hadRegion(const Plane& planeLocal) const;
    double predictedError();
    std::optional<FitFailure> addElseTo(std::optional<FitFailure> refused);
    std::optional<FitFailure> addAll(const Partition& partition, const FitChoice& fit);
    std::optional<FitFailure> add(const Cell& cell, const FitChoice& fit);
    Candidate* serving(Vec3d pointLocal, double rounding = 0);
    bool keepUnserved();
    bool isNewMapDue(const SceneOptimalFit& fit) const;
    void gatherEdgesIn(const CellPlanes& cell);
    void findNeeds();
    void findUnservedRays();
    Plane turnedToLight(const Plane& plane) const;
    bool holdsAllSeen(const Plane& plane) const;
    bool takeAwayServed(const RaySpace& space);
    std::optional<Fit> cropped(const Fit& fit, const Cell& cell);
    std::optional<LixelRectangle> leftOfBudget(int layer) const;
    bool sizeAll(const LookupLayout& lookup, std::span<LixelSize> sizes) const;

    const PlanInput& input_;
    FitScratch& scratch_;
    FitInput fitInput_;
    NeedPredictor predictor_;
    Candidates candidates_;
    std::size_t number_;                               // the light's
    std::optional<std::span<const Vec3d>> triedLocal_; // what stands for the view samples while plans are only tried
    std::span<const Vec3d> seenLocal_;                 // view samples that face the light and are still to be served
    std::optional<FramedBody> visible_;                // all that may be seen, where rays were found from it
    bool isCropping_ = false;                          // what is added now serves scratch.rays only
};

} // namespace lixel
