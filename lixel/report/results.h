// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/judge/on_planes.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

// The results of one run, as results.json and report.html tell them. docs/results.schema.json is their form in JSON;
// percentages are made from the counts there, so that they cannot disagree.
namespace lixel {

// Counts of light-facing view samples in one part of the picture.
struct SampleCount
{
    std::int64_t samples = 0;
    std::int64_t misclassified = 0;
};

// Of a value over the light-facing view samples.
struct Percentiles
{
    double p1 = 0, p10 = 0, p50 = 0, p90 = 0, p99 = 0, max = 0;
};

// Against another executor that was asked about the same view samples.
struct Agreement
{
    std::string executor;        // the other one
    double agreementPercent = 0; // samples for which both say the same
    std::optional<double>
        sharedMisclassifiedPercent; // of the samples that either got wrong, those that both did; no value: none wrong
    std::optional<double> lixelsAgreeingPercent =
        {}; // of the light's maps, with depths that agree to 1e-4 of the range
};

// Samples that could flip between two frames, and those that do (judge/temporal.h).
struct FlipCount
{
    std::int64_t samples = 0;
    std::int64_t flips = 0;
};

// From the frame before to the one at this time.
struct FramePairFlips
{
    double seconds = 0;
    FlipCount count;
};

// How steady shadows are along a path. The row's counts are then sums over its frames.
struct Temporal
{
    std::int64_t frames = 0;
    std::int64_t refusedFrames = 0; // which count nowhere else
    double fromSeconds = 0, toSeconds = 0;
    bool isStill = false; // casters and light were held, only the camera moved
    FlipCount all, edgeBand, terminatorBand, interior;
    std::vector<FramePairFlips> pairs; // one less than frames; no samples where either frame was refused
};

// Files of the run's folder, relative to it; empty: not made.
struct PictureFiles
{
    std::string shaded;    // the picture with this technique's shadows
    std::string error;     // errorPicture() of false_colour.h
    std::string footprint; // footprintPicture() of false_colour.h
    std::string density;   // densityPicture() of false_colour.h
    std::string boundary;  // boundaryPicture() of false_colour.h: what the plan was told
};

struct PassTime
{
    std::string name;
    double ms = 0;
};

// All that depends on the clock and the machine.
struct RowTiming
{
    std::optional<double> frameMs; // median of undisturbed frames
    std::vector<PassTime> passes;  // measured apart, in the order they ran
    std::optional<double> gpuMs;   // no value on software drivers
    std::string clock;             // what `ms` was taken with, e.g. "steady_clock after glFinish"
};

struct RunTiming
{
    std::string date; // ISO 8601, UTC
    std::string host; // processor, cores and driver
    double totalSeconds = 0;
};

// Samples on one of the scene's planes of interest, or on none of them.
struct PlaneSamples
{
    std::string plane;
    SampleCount count;
    std::optional<PlaneErrorCauses> causes = {}; // of a plane with a lixel a pixel
};

// One map of a light, in the order they serve.
struct RegionUse
{
    std::string plane;         // that it is for; empty: another region
    int width = 0, height = 0; // lixels
};

// A plane that a technique asks for and that has no map.
struct LeftOut
{
    std::string plane, reason;
};

// Partial shadow against what it may stand for, over the samples of the edge band.
struct TruthError
{
    double rmse = 0, largest = 0;
};
struct ShadeQuality
{
    std::int64_t distinct = 0;          // shades of light-facing samples
    double transitionPixels = 0;        // from 5 to 95 % lit, across the boundary of exact visibility
    double bleedingPercent = 0;         // mean light of interior samples that are exactly dark
    SampleCount darkInterior;           // these, and those of them that are lit when rounded
    TruthError area;                    // against the share of the pixel that is lit
    std::optional<double> filterLixels; // a side of what the lookup averages over; no value: a technique without a map
    std::optional<TruthError> filtered; // against the share of that square that is lit
};

struct Measurement
{
    std::int64_t lightFacing = 0; // view samples that count
    std::int64_t misclassified = 0;
    std::int64_t falseShadow = 0; // dark, exactly lit
    std::int64_t falseLit = 0;    // lit, exactly dark
    SampleCount edgeBand, terminatorBand, interior;
    std::vector<PlaneSamples> planes; // of scenes that name some: in their order, then, unnamed, the rest
    std::int64_t unserved = 0;        // view samples that no region held
    std::int64_t lixelsUsed = 0;      // all lixels drawn or allocated for the light in a frame
    std::vector<RegionUse> regions;
    std::vector<LeftOut> leftOut;
    std::int64_t bytes = 0;                             // of all maps and tables of the light
    std::optional<Percentiles> footprintPixelsPerLixel; // no value: a technique without a map
    std::optional<Percentiles> densityLixelsPerPixel;
    std::optional<Agreement> agreement;
    std::optional<Temporal> temporal;   // no value: of a single picture
    std::optional<ShadeQuality> shades; // where it was asked for
    PictureFiles pictures;
    RowTiming timing;
};

struct Refusal
{
    std::string reason;  // the name, e.g. "extent-not-in-hemisphere"
    std::string message; // one line for people
};

// One technique, light and view. The members before `outcome`, technique apart, are its key.
struct ResultRow
{
    std::string scene, view, light;
    std::string techniqueFull; // canonical, with every default
    std::string lixels;        // the budget: "512x512", or one for each map: "350x350,128x128"
    std::string size;          // of the picture: "1024x1024"
    std::string executor;      // "gl" or "trace"
    std::uint64_t seed = 0;
    std::string technique; // as it was typed
    std::variant<Measurement, Refusal> outcome;

    const Measurement* measured() const { return std::get_if<Measurement>(&outcome); }
    const Refusal* refused() const { return std::get_if<Refusal>(&outcome); }
};

struct RunResults
{
    std::string lixelVersion; // part of every row's key
    std::string command;      // repeats the run, quoted for a POSIX shell
    std::uint64_t seed = 0;
    std::vector<ResultRow> rows; // in any order
    RunTiming timing;
};

// By scene, view, light, technique_full, lixels, size, executor, seed; no locale.
void sortByKey(std::vector<ResultRow>& rows);

} // namespace lixel
