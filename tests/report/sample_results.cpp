// SPDX-License-Identifier: MIT
#include "sample_results.h"

#include "lixel/report/false_colour.h"
#include "lixel/report/png.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lixel::test {
namespace {

struct SampleTechnique
{
    std::string name;
    double lixelSize; // of the floor, in units of a disc's radius; 0: exact
    double frameMs;
};

// Seen over a floor that runs to the horizon at the picture's upper quarter.
struct SampleScene
{
    std::string view;
    double sunX; // how far shadows fall to the side
    int size;

    Image<Rgba8> shaded;
    Image<Verdict> verdicts;
    Image<float> footprint, density;
    Measurement measurement;
};

bool isLit(double x, double z, double sunX)
{
    const double cellX = std::floor((x - sunX) / 4) * 4 + 2, cellZ = std::floor(z / 4) * 4 + 2;
    return std::hypot(x - sunX - cellX, z - cellZ) > 1;
}

Rgba8 floorColour(double x, double z, bool lit)
{
    const bool isLight = (int(std::floor(x / 2)) + int(std::floor(z / 2))) % 2 == 0;
    const double value = (isLight ? 205 : 165) * (lit ? 1 : 0.45);
    return {std::uint8_t(value), std::uint8_t(value * 0.95), std::uint8_t(value * 0.86), 255};
}

void drawPixel(SampleScene& scene, const SampleTechnique& technique, int i, int j)
{
    const double u = (i + 0.5) / scene.size * 2 - 1, below = 0.75 - (j + 0.5) / scene.size;
    if (below <= 0.02) { // the sky
        scene.shaded(i, j) = {150, 180, std::uint8_t(215 + 30 * below), 255};
        return;
    }
    const double z = 3 / below, x = u * z;
    const double step = technique.lixelSize;
    const auto stepped = [&](double value) { return step > 0 ? (std::floor(value / step) + 0.5) * step : value; };
    const bool exact = isLit(x, z, scene.sunX), lit = isLit(stepped(x), stepped(z), scene.sunX);
    scene.shaded(i, j) = floorColour(x, z, lit);
    scene.verdicts(i, j) = lit == exact ? Verdict::Right : lit ? Verdict::FalseLit : Verdict::FalseShadow;
    if (step > 0) {
        const double pixelWidth = 2 * z / scene.size, pixelDepth = z * z / 3 / scene.size;
        scene.footprint(i, j) = float(step / std::min(pixelWidth, pixelDepth));
        scene.density(i, j) = float(pixelWidth * pixelDepth / (step * step));
    }

    Measurement& measurement = scene.measurement;
    ++measurement.lightFacing;
    measurement.misclassified += lit != exact;
    measurement.falseLit += lit && !exact;
    measurement.falseShadow += !lit && exact;
}

Measurement measure(SampleScene& scene, const SampleTechnique& technique)
{
    scene.shaded = Image<Rgba8>(scene.size, scene.size);
    scene.verdicts = Image<Verdict>(scene.size, scene.size, Verdict::NotCounted);
    scene.footprint = scene.density = Image<float>(scene.size, scene.size, std::numeric_limits<float>::quiet_NaN());
    scene.measurement = {};
    for (int j = 0; j < scene.size; ++j)
        for (int i = 0; i < scene.size; ++i) drawPixel(scene, technique, i, j);

    Measurement& measurement = scene.measurement;
    measurement.edgeBand = {measurement.lightFacing / 5, measurement.misclassified};
    measurement.interior = {measurement.lightFacing - measurement.edgeBand.samples, 0};
    measurement.timing = {.frameMs = technique.frameMs, .passes = {}, .gpuMs = {}, .clock = "steady_clock"};
    if (technique.lixelSize > 0) {
        measurement.timing.passes = {{"shadow depth", 0.7 * technique.frameMs}, {"lookup", 0.25 * technique.frameMs}};
        measurement.lixelsUsed = 512 * 512;
        measurement.bytes = 512 * 512 * 4;
        measurement.footprintPixelsPerLixel = Percentiles{0.1, 0.3, 1.2, 4.5, 9.75, 31};
        measurement.densityLixelsPerPixel = Percentiles{0.01, 0.05, 0.7, 3.2, 9, 40};
        measurement.shades = ShadeQuality{17, 2.5, 0.25, {400, 1}, {0.125, 0.75}, 4.0, TruthError{0.0625, 0.5}};
    }
    return measurement;
}

// The more errors a technique has, the more of them flip, in waves; the third frame was refused.
Temporal anyFlips(const Measurement& of)
{
    Temporal temporal;
    temporal.frames = 9;
    temporal.refusedFrames = 1;
    temporal.fromSeconds = 0.5, temporal.toSeconds = 4.5;
    for (int i = 1; i < temporal.frames; ++i) {
        const bool isRefused = i == 2 || i == 3;
        const auto flips = std::int64_t(double(of.misclassified) * (1.2 + std::sin(i)) / 3);
        const FlipCount count = isRefused ? FlipCount{} : FlipCount{of.lightFacing, flips};
        temporal.pairs.push_back({0.5 + 0.5 * i, count});
        temporal.all.samples += count.samples, temporal.all.flips += count.flips;
    }
    temporal.edgeBand = {temporal.all.samples / 5, temporal.all.flips};
    temporal.interior = {temporal.all.samples - temporal.edgeBand.samples, 0};
    return temporal;
}

PictureFiles writePictures(const fs::path& folder, const std::string& name, const SampleScene& scene)
{
    const PictureFiles files{name + ".png", name + "-error.png", name + "-footprint.png", name + "-density.png", ""};
    writePng(folder / files.shaded, scene.shaded);
    writePng(folder / files.error, errorPicture(scene.verdicts));
    writePng(folder / files.footprint, footprintPicture(scene.footprint));
    writePng(folder / files.density, densityPicture(scene.density));
    return files;
}

ResultRow rowOf(const SampleScene& scene, const std::string& technique, const std::string& executor)
{
    ResultRow row;
    row.scene = "bunnies";
    row.view = scene.view;
    row.light = "sun";
    row.technique = technique;
    row.techniqueFull = "whole+" + technique + "+depths(1,max)+pcf(1)";
    row.lixels = "512x512";
    row.size = std::to_string(scene.size) + "x" + std::to_string(scene.size);
    row.executor = executor;
    row.seed = 1;
    return row;
}

void addRows(RunResults& run, SampleScene& scene, const SampleTechnique& technique, const fs::path& folder)
{
    for (const char* executor : {"gl", "trace"}) {
        ResultRow row = rowOf(scene, technique.name, executor);
        Measurement measurement = measure(scene, technique);
        measurement.agreement = Agreement{row.executor == "gl" ? "trace" : "gl", 99.98, 96.5, 99.9};
        const std::string name = scene.view + "_" + technique.name + "_" + executor;
        if (!folder.empty()) measurement.pictures = writePictures(folder, name, scene);
        row.outcome = measurement;
        run.rows.push_back(row);
    }
}

RunResults makeRun(const fs::path& folder, int size)
{
    RunResults run;
    run.lixelVersion = "0.1.0";
    run.seed = 1;
    run.command =
        "lixel compare bunnies --techniques exact,uniform,focused,lispsm,plane-optimal --lixels 512x512 --size " +
        std::to_string(size) + "x" + std::to_string(size) + " --executor gl,trace --seed 1 -o out";
    run.timing = {"2024-05-06T07:08:09Z", "two cores, llvmpipe", 12.5};
    for (const auto& [view, sunX] : {std::pair{"front", 0.8}, std::pair{"low camera", -1.5}}) {
        SampleScene scene{view, sunX, size, {}, {}, {}, {}, {}};
        for (const SampleTechnique& technique :
             {SampleTechnique{"uniform", 0.9, 3.1}, SampleTechnique{"exact", 0, 80},
              SampleTechnique{"focused", 0.31, 3.4}, SampleTechnique{"lispsm", 0.12, 3.6}})
            addRows(run, scene, technique, folder);
        ResultRow refused = rowOf(scene, "plane-optimal", "gl");
        refused.outcome = Refusal{"no-plane", "plane-optimal needs a region with a plane: add planes(floor)"};
        run.rows.push_back(refused);
    }
    return run;
}

} // namespace

TemporaryFolder::TemporaryFolder()
{
    std::string name = (fs::temp_directory_path() / "lixel-test-XXXXXX").string();
    path_ = mkdtemp(name.data());
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::size_t TemporaryFolder::fileCount() const
{
    return std::size_t(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
}

std::string readWhole(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

RunResults sampleRun(const fs::path& folder, int size) { return makeRun(folder, size); }
RunResults sampleRun() { return makeRun({}, 32); }

RunResults samplePath(const fs::path& folder, int size)
{
    RunResults run = makeRun(folder, size);
    for (ResultRow& row : run.rows)
        if (auto* measurement = std::get_if<Measurement>(&row.outcome)) measurement->temporal = anyFlips(*measurement);
    return run;
}
RunResults samplePath() { return samplePath({}, 32); }

namespace {

// Samples along the picture's diagonal.
Observation anyObservation(int size)
{
    Observation observed;
    observed.grid = {8, 8};
    observed.samples.width = observed.samples.height = size;
    for (int cell = 0; cell < 8; ++cell) {
        const float at = (float(cell) + 0.5f) * float(size) / 8;
        observed.samples.pixel.push_back({at, at});
        observed.samples.positionLocal.push_back({at, at, 0});
        observed.samples.normal.push_back({0, 0, 1});
    }
    observed.samples.atDepthJump.assign(8, 0);
    observed.lit.assign(8, 0);
    observed.atBoundary.assign(8, 1);
    return observed;
}

} // namespace

Reproduction sampleReproduction(const fs::path& folder, int size)
{
    Reproduction out;
    out.name = "shadows-of-discs";
    out.paper = "A. Author. A Paper. 2004, Table 1";
    out.question = "Which is better?";
    out.isQuick = true;
    out.claims = {{"Discs cast <round> shadows.", "section 2", "1.5 (corners a shadow)", false, false},
                  {"They are fast.", "section 3", "290 (frames a second)", true, true},
                  {"All discs are round.", "section 4", "3 of 4 discs; open: too few", std::nullopt, false}};
    out.run = makeRun(folder, size);
    out.parameters = {{"size", std::to_string(size)}, {"view", "front"}};
    out.numbers = {{"uniform over focused", "ratio", 2.5, 2.25, "Table 1"},
                   {"focused, mean", "percent", 0.125, std::nullopt, "no numbers"}};
    out.timingNumbers = {{"focused", "frames a second", 290, 30, "section 4"}};
    out.tables = {{"Errors by method",
                   "misclassified pixels a picture",
                   "Table 1",
                   {{"Focused", "focused"}, {"Normal", "uniform"}, {"Light space", "lispsm"}},
                   {{"using all data", {{2000, 1600}, {5000, 4000}, {1500, std::nullopt}}},
                    {"worst 10 % by Normal", {{0, std::nullopt}, {7000, std::nullopt}, {4000, std::nullopt}}}}}};
    out.charts = {{"Corners", "discs", "a shadow", {{"ours", {{1, 2}, {4, 8}}}, {"theirs", {{1, 3}}}}, false},
                  {"Frames", "discs", "a second", {{"ours", {{1, 290}, {4, 70}}}}, true}};
    for (const char* view : {"front", "low camera"})
        out.figures.push_back({std::string("from the ") + view,
                               "bunnies",
                               view,
                               "sun",
                               {"uniform", "focused", "exact"},
                               size / 4,
                               size / 2,
                               size / 8,
                               PictureLayer::None});
    out.figures.back().layer = PictureLayer::Boundary;
    out.plates = {{"how a map is made", {{"counted", "counted.png"}, {"moved", "counted.png"}}}};
    if (folder.empty()) return out;
    writePng(folder / "counted.png", Image<Rgba8>(4, 3, {80, 90, 100, 255}));
    const char* const boundary = "boundary.png";
    writePng(folder / boundary, boundaryPicture(anyObservation(size), 0));
    for (ResultRow& row : out.run.rows)
        if (auto* measured = std::get_if<Measurement>(&row.outcome)) measured->pictures.boundary = boundary;
    return out;
}

PlaneBudget samplePlaneBudget(const fs::path& folder, int size)
{
    PlaneBudget out{"How does error fall?", true, {}, 1, makeRun(folder, size)};
    for (const bool isOnPlanes : {true, false}) {
        out.curves.push_back(
            {"bunnies", "focused", isOnPlanes, {{"128x128", 16384, {10000, 400}}, {"512x512", 262144, {10000, 90}}}});
        out.curves.push_back({"bunnies",
                              "planes(floor)+plane-optimal+allocation=exact",
                              isOnPlanes,
                              {{"512x512", 70000.5, {10000, isOnPlanes ? 0 : 250}}}});
    }
    return out;
}

LookupStudy sampleLookups(const fs::path& folder, int size)
{
    LookupStudy out{"Which does none beat?", true, 1, {}, {}, {}, makeRun(folder, size)};
    const auto add = [&](const char* name, int bytes, double percent, double bleeding, std::optional<double> filtered,
                         std::optional<LookupStudy::Times> times) {
        out.lookups.push_back({name,
                               "whole+focused+" + std::string(name),
                               bytes,
                               bytes,
                               12,
                               3456,
                               percent,
                               percent / 3,
                               5,
                               1.5,
                               bleeding,
                               {1000, 2},
                               0.25,
                               0.75,
                               filtered ? std::optional(2.0) : std::nullopt,
                               filtered,
                               filtered ? std::optional(0.5) : std::nullopt,
                               times});
    };
    add("pcf(1)", 4, 3.0, 0, 0.2, LookupStudy::Times{1, 1, 0, 4.5});
    add("bilinear", 4, 2.5, 0, {}, LookupStudy::Times{1.05, 1.5, 0, 6});
    add("msm", 36, 2.75, 1.5, 0.1, LookupStudy::Times{1.25, 3, 4, 9});
    add("untimed", 8, 2.0, 0.5, 0.15, {});
    out.fronts = {{"misclassified_percent", "bytes_per_lixel", {"bilinear", "untimed"}},
                  {"filtered_rmse", "bytes_per_lixel", {"pcf(1)", "untimed", "msm"}}};
    out.frontsOfTimes = {{"misclassified_percent", "frame_ratio", {"pcf(1)", "bilinear"}}};
    return out;
}

} // namespace lixel::test
