// SPDX-License-Identifier: MIT
#pragma once

#include "executor.h"
#include "lixel/judge/on_planes.h"
#include "lixel/judge/score.h"
#include "lixel/plan/technique.h"
#include "lixel_agreement.h"
#include "picture_options.h"
#include "progress.h"
#include "shadows.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

// Techniques against exact visibility of the same view samples.
namespace lixel::app {

struct ComparisonOptions
{
    std::vector<TechniqueChoice> techniques;
    LixelBudget lixels;
    int timingFrames = 5;           // 0: no times
    std::size_t footprintStep = 1;  // footprints are of one sample in so many; with pictures of all
    PlanMemory memory = {};         // what plans know of the frame before
    bool withShades = false;        // compareShot() asks for partial truth
    int filterRays = 16;            // a side of a filter's footprint
    std::filesystem::path pictures; // folder for PNGs; empty: none
};

// Samples of the edge band of one light, all or some, and the share of the pixel around each that is lit (exact-area).
struct PartialTruth
{
    std::vector<std::size_t> band; // of the shot's samples
    ViewSamples samples;           // those
    std::vector<float> area;
};

// Exact visibility of one shot and what follows from it.
struct Truth
{
    std::vector<std::vector<float>> exact; // [light][sample]
    std::vector<std::vector<Zone>> zones;  // [light][sample]
    std::vector<int> plane;                // [sample]: on which of the scene's planes, or kOnNoPlane
    std::vector<PartialTruth> partial;     // [light], where it is asked for (shade_quality.h): rows then have shades
};
Truth findTruth(const Stage& stage, const ViewSamples& samples, std::span<const Light> lights,
                std::span<const NamedPlane> planes);

// All rows of one shot: techniques x lights x executors. The first executor provides the view samples; with two, rows carry
// their agreement.
std::vector<ResultRow> compareShot(const Shooting& shooting, const Shot& shot, const Stage& stage, const View& view,
                                   std::span<const std::unique_ptr<Executor>> executors,
                                   const ComparisonOptions& options,
                                   const std::function<void(std::string_view)>& onStep);

// Steps that compareShot() reports; without the two before the techniques, those that compareTechniques() does.
int stepsPerShot(std::size_t executors, const ComparisonOptions& options);

// ---- what compareShot() is made of, for those who compare many frames

// What the whole of one shot shares.
struct ShotContext
{
    const Shooting& shooting;
    const Shot& shot;
    const Stage& stage;
    const View& view;
    const ViewSamples& samples;
    const Truth& truth;
    const ComparisonOptions& options;
};

// What compareShot() says, of samples that are known: for those who ask about them more than once.
std::vector<ResultRow> compareTechniques(const ShotContext& context,
                                         std::span<const std::unique_ptr<Executor>> executors,
                                         const std::function<void(std::string_view)>& onStep);

// A row without outcome.
ResultRow keyOf(const ShotContext& context, const TechniqueChoice& choice, std::size_t light,
                std::string_view executor);

// The counts of a row.
Measurement measured(const ShotContext& context, std::size_t light, const Visibility& visibility);

// `lixels`: none of a technique without a map.
Agreement agreementWith(std::string_view other, const ExecutorAgreement& a, const LixelAgreement& lixels);

// Footprint and density of light-facing samples that the light's map serves.
struct Density
{
    Image<float> pixelsPerLixel, lixelsPerPixel; // NaN where there is none
    std::vector<double> pixelsPerLixelList, lixelsPerPixelList;
};

// Of every `step`-th sample, the one with number `first` among them.
Density densityOf(const ShotContext& context, const ShadowPlan& plan, std::size_t light, std::size_t first = 0,
                  std::size_t step = 1);

// Nothing of nothing.
std::optional<Percentiles> percentiles(std::vector<double> values);

// The rows of one technique by one executor, with pictures and times: one a light. `plan` is planFor() of it, or null.
std::vector<ResultRow> rowsOf(const ShotContext& context, Executor& executor, const TechniqueChoice& choice,
                              std::span<const Visibility> visibility, const FramePlan* plan);

} // namespace lixel::app
