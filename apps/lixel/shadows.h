// SPDX-License-Identifier: MIT
#pragma once

#include "executor.h"
#include "lixel/plan/footprint.h"
#include "lixel/plan/technique.h"
#include "picture_options.h"
#include "text.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// From a technique to visibility: by a plan, which executors run, or without a map.
namespace lixel::app {

// A technique as it was asked for, with what it takes from files.
struct TechniqueChoice
{
    std::string typed;
    Technique technique;
    std::vector<GivenLight> given = {}; // of matrix(file) and plan(file)
};

// Throws UsageError for text, InputError for files.
std::vector<TechniqueChoice> readTechniques(const std::string& list);

// One technique; the files that it names are relative to `folder`. Likewise.
TechniqueChoice chooseTechnique(const std::string& text, const std::filesystem::path& folder = {});

// What it takes from a file: the file's name as it was typed, or nothing.
std::string fileNamedBy(const Technique& technique);

// Refuses names of planes that the scene does not have, with those it has.
void expectPlanes(std::span<const TechniqueChoice> techniques, const Shooting& shooting);

// What a plan is made for, next to the technique.
struct PlanSubject
{
    const Stage& stage;
    const View& view;
    std::span<const Light> lights;
    std::span<const NamedPlane> planes;
    const ViewSamples& seen; // what the view sees
};

// What the frames of a path hand on, of one technique.
struct PlanMemory
{
    std::vector<LightMemory> before;
    std::optional<Observation> observed; // of the frame before; nothing at the start
};

// The plan of a technique with a map, for all lights, or of the maps that exact-filtered stands for; nothing for the others. Where memory has nothing observed, the executor runs the
// first pass of techniques that have one.
std::optional<FramePlan> planFor(const TechniqueChoice& choice, const PlanSubject& subject, const LixelBudget& lixels,
                                 Executor& executor, const PlanMemory& memory = {});

// The same where a device makes the warps itself; nothing for techniques whose warps it cannot make, or that have none.
std::optional<WarpLayout> warpLayoutFor(const TechniqueChoice& choice, const PlanSubject& subject,
                                        const LixelBudget& lixels);

// What the next frame may know of this one.
PlanMemory memoryOf(const TechniqueChoice& choice, const PlanSubject& subject, const FramePlan& plan,
                    std::span<const Visibility> visibility);

// What a technique without a map says, one a light. Rays are the same for all executors; shadow volumes may be refused. `plan` is
// planFor() of the technique, or null: a light that it refuses has an empty one.
Expected<std::vector<Visibility>, Refusal> visibilityWithoutMap(const Technique& technique, Executor& executor,
                                                                const Stage& stage, const View& view,
                                                                const ViewSamples& samples,
                                                                std::span<const Light> lights, const FramePlan* plan);

// Footprints in the light image that serves a point: of the first region that holds it. The plan must outlive it.
class ServedFootprints
{
public:
    ServedFootprints(const View& view, Vec3d originWorld, const ShadowPlan& plan);
    std::optional<Footprint> at(Vec3d pointLocal, Vec3d normal) const;

private:
    const View& view_;
    Vec3d originWorld_;
    struct Served
    {
        LightImage image;
        CellPlanes halfSpacesLocal;
    };
    std::vector<Served> served_;
};

} // namespace lixel::app
