// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/expected.h"
#include "lixel/plan/fit/plane_optimal.h"
#include "lixel/plan/fit/psm.h"
#include "lixel/plan/fit/scene_optimal.h"
#include "lixel/plan/lookup/choices.h"
#include "lixel/plan/warp/warp_choice.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// What a technique is (partition x fit x warp x lookup, or one without a map), and its text form:
//
//   word(value, key=value, ...) joined by +, order free; word:a:b means word(a,b)
//
// Parts left out take their default: whole + focused + no warp + depths(1) + pcf(1); sdsm(n) goes with desired-view, and if
// stable with focused; planes(...) goes with plane-optimal, which ends in else(focused) but where uncovered=lit. `stable` stands among the arguments of a partition or fit and is the technique's: pssm(4,stable) is
// pssm(4)+focused(stable).
namespace lixel {

// Partitions.
struct WholePartition
{
    friend bool operator==(const WholePartition&, const WholePartition&) = default;
};
struct PssmPartition
{
    int count = 4;       // 1 to 16
    double lambda = 0.5; // 1: logarithmic, 0: even
    friend bool operator==(const PssmPartition&, const PssmPartition&) = default;
};
struct SdsmPartition
{
    int count = 4;
    friend bool operator==(const SdsmPartition&, const SdsmPartition&) = default;
};
struct CubePartition
{
    friend bool operator==(const CubePartition&, const CubePartition&) = default;
};
// With uniform, focused and desired-view, which say how much of the half spheres the maps hold.
struct DualParaboloidPartition
{
    std::optional<WarpRaster> raster; // of a technique with a warp nothing: that says how casters get into its maps
    friend bool operator==(const DualParaboloidPartition&, const DualParaboloidPartition&) = default;
};
// Planes of interest by the names that the scene gives them, in order of priority; or those that lixel finds in what the view sees.
struct PlanesPartition
{
    std::vector<std::string> names; // empty: auto
    Twist twist = Twist::Tight;
    friend bool operator==(const PlanesPartition&, const PlanesPartition&) = default;
};
using Partition =
    std::variant<WholePartition, PssmPartition, SdsmPartition, CubePartition, DualParaboloidPartition, PlanesPartition>;

// Fits.
struct UniformFit
{
    friend bool operator==(const UniformFit&, const UniformFit&) = default;
};
struct FocusedFit
{
    friend bool operator==(const FocusedFit&, const FocusedFit&) = default;
};
struct DesiredViewFit
{
    bool isRotated = false;
    friend bool operator==(const DesiredViewFit&, const DesiredViewFit&) = default;
};
struct MinimalFrustumFit
{
    friend bool operator==(const MinimalFrustumFit&, const MinimalFrustumFit&) = default;
};
struct PsmFit
{
    PsmShift shift = PsmShift::Casters;
    friend bool operator==(const PsmFit&, const PsmFit&) = default;
};
struct TsmFit
{
    std::optional<double> focusDepth; // world units from the eye
    friend bool operator==(const TsmFit&, const TsmFit&) = default;
};
struct LispsmFit
{
    friend bool operator==(const LispsmFit&, const LispsmFit&) = default;
};
// What another engine chose: one matrix a light, or regions with their rectangles. PlanInput::given has what the file says.
struct MatrixFit
{
    std::string file;
    friend bool operator==(const MatrixFit&, const MatrixFit&) = default;
};
struct PlanFit
{
    std::string file;
    friend bool operator==(const PlanFit&, const PlanFit&) = default;
};
using FitChoice = std::variant<UniformFit, FocusedFit, DesiredViewFit, MinimalFrustumFit, PsmFit, TsmFit, LispsmFit,
                               PlaneOptimalFit, SceneOptimalFit, MatrixFit, PlanFit>;

// How the regions of a light share its lixels.
enum class Allocation {
    Need,  // so that the predicted error of all is least; evenly where there are no view samples to predict from
    Share, // evenly; the default of stable techniques, whose lixels must not change size
    Exact // planes have a lixel a pixel, as many as that takes, just where pixels are; others share what is left by need
};

// What serves receivers that fall out of all regions.
struct Fallback
{
    Partition partition = WholePartition{};
    FitChoice fit = FocusedFit{};
    friend bool operator==(const Fallback&, const Fallback&) = default;
};

// A technique with a map.
struct MapTechnique
{
    Partition partition = WholePartition{};
    FitChoice fit = FocusedFit{};
    bool isStable = false; // maps do not crawl as the camera moves
    Allocation allocation = Allocation::Need;
    std::optional<Fallback> otherwise = {};
    WarpChoice warp = NoWarp{}; // of every region
    Store store = DepthStore{};
    Kernel kernel = PcfKernel{};
    bool isDualPlane = false; // what is in shadow must also lie behind the plane of the surface that is stored
    friend bool operator==(const MapTechnique&, const MapTechnique&) = default;
};

// Whether plans of it are made from view samples, and need PlanInput::seen.
bool needsViewSamples(const MapTechnique& technique);

// How casters get into maps that no matrix draws.
WarpRaster rasterOf(const MapTechnique& technique);

// Of the technique or of its else(...); null where neither is.
const SceneOptimalFit* sceneOptimalOf(const MapTechnique& technique);

// Techniques without one: a ray a view sample, `samples` rays over the pixel's area, or counting the volumes that silhouettes bound
// (Crow 1977), on the device.
struct ExactTechnique
{
    friend bool operator==(const ExactTechnique&, const ExactTechnique&) = default;
};
struct ExactAreaTechnique
{
    int samples = 64; // a square number
    friend bool operator==(const ExactAreaTechnique&, const ExactAreaTechnique&) = default;
};
// What a filter of some maps stands for: `rays` rays over the square of lixels that their lookup averages over.
struct ExactFilteredTechnique
{
    MapTechnique filtered; // whose light images and lookup
    int rays = 256;        // a square number
    friend bool operator==(const ExactFilteredTechnique&, const ExactFilteredTechnique&) = default;
};
struct ShadowVolumesTechnique
{
    friend bool operator==(const ShadowVolumesTechnique&, const ShadowVolumesTechnique&) = default;
};

using Technique =
    std::variant<MapTechnique, ExactTechnique, ExactAreaTechnique, ExactFilteredTechnique, ShadowVolumesTechnique>;

// Of the technique, or of what exact-filtered stands for: what must be planned. Null for the others.
const MapTechnique* mapsOf(const Technique& technique);

// Whether it draws maps: what is planned for exact-filtered is not drawn.
bool hasMap(const Technique& technique);

// Says what is wrong in one line that quotes the text and names what is known.
Expected<Technique, std::string> parseTechnique(std::string_view text);

// The canonical form with every default; parses back to the same value.
std::string toString(const Technique& technique);

// A list as the command line takes it: split at commas outside parentheses only.
Expected<std::vector<std::string>, std::string> splitTechniques(std::string_view list);

// One row of what `lixel techniques` prints.
struct TechniqueWord
{
    std::string_view kind; // partition, fit, warp, store, kernel, no map, preset
    std::string_view form; // pcf(k)
    std::string_view meaning;
    std::string_view paper;
    std::string_view lights;   // those it serves
    std::string_view refusals; // when it says no
};
std::span<const TechniqueWord> techniqueWords();

} // namespace lixel
