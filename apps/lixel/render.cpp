// SPDX-License-Identifier: MIT
#include "commands.h"
#include "comparison.h"
#include "exit_code.h"
#include "lixel/report/exr.h"
#include "lixel/report/png.h"
#include "lixel/trace/exact_visibility.h"
#include "output.h"
#include "plan_file.h"
#include "run_results.h"
#include "shadows.h"
#include "text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

struct RenderOptions
{
    PictureOptions picture;
    std::string output, exr, plan;
    std::string technique = "focused+else(cube)+pcf(9)";
    std::string lixels = "2048x2048";
    std::string executor = "gl";
    bool withExact = false, withFootprint = false, withDensity = false;
};

// Everything known of one picture.
struct Picture
{
    const Shot& shot;
    const Stage& stage;
    std::span<const NamedPlane> planes;
    View view;
    ViewSamples samples;
    std::optional<FramePlan> plan;      // planFor()
    std::vector<Visibility> visibility; // one a light
};

// Throws RefusedError where a light's shadows cannot be had; one that reaches nothing in the picture has none to make.
void expectPlanned(const FramePlan& plan, const TechniqueChoice& choice, std::span<const Light> lights)
{
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (const auto refused = plan.lights[i].refused; refused && *refused != FitFailure::NothingInView)
            throw RefusedError(fmt::format("{}: light \"{}\" is refused: {} ({}); --technique exact serves every light",
                                           choice.typed, lights[i].name, sentenceFor(*refused), nameOf(*refused)));
}

void addShadows(Picture& picture, Executor& executor, const TechniqueChoice& choice, const LixelBudget& lixels)
{
    const auto& lights = picture.shot.lights;
    picture.plan =
        planFor(choice, {picture.stage, picture.view, lights, picture.planes, picture.samples}, lixels, executor);
    if (picture.plan) expectPlanned(*picture.plan, choice, lights);
    if (hasMap(choice.technique)) {
        picture.visibility = executor.run(picture.stage, *picture.plan, picture.samples);
    } else {
        auto visibility = visibilityWithoutMap(choice.technique, executor, picture.stage, picture.view, picture.samples,
                                               lights, picture.plan ? &*picture.plan : nullptr);
        if (!visibility)
            throw RefusedError(fmt::format("{} is refused: {} ({})", choice.typed, visibility.error().message,
                                           visibility.error().reason));
        picture.visibility = std::move(visibility).value();
    }
    for (Visibility& light : picture.visibility) light.value.resize(picture.samples.size(), 0.0f);
}

// A float plane of the picture, filled from values of the samples; what no sample covers keeps `empty`.
class Channels
{
public:
    explicit Channels(const ViewSamples& samples) : samples_(samples) {}

    template <typename ValueOf>
    void add(const std::string& name, float empty, ValueOf valueOf)
    {
        Image<float> plane(samples_.width, samples_.height, empty);
        for (std::size_t i = 0; i < samples_.size(); ++i)
            plane(int(samples_.pixel[i].x), int(samples_.pixel[i].y)) = float(valueOf(i));
        names_.push_back(name);
        planes_.push_back(std::move(plane));
    }
    void write(const std::string& path) const
    {
        std::vector<ExrChannel> channels;
        for (std::size_t i = 0; i < planes_.size(); ++i) channels.push_back({names_[i], planes_[i].data()});
        writeExr(path, samples_.width, samples_.height, channels, samples_.originWorld);
    }

private:
    const ViewSamples& samples_;
    std::vector<std::string> names_;
    std::vector<Image<float>> planes_;
};

void addSurfaces(Channels& channels, const Picture& picture)
{
    const ViewSamples& s = picture.samples;
    const Mat4d clip = clipFromLocal(picture.view, s.originWorld);
    channels.add("position.X", kNone, [&](std::size_t i) { return s.positionLocal[i].x; });
    channels.add("position.Y", kNone, [&](std::size_t i) { return s.positionLocal[i].y; });
    channels.add("position.Z", kNone, [&](std::size_t i) { return s.positionLocal[i].z; });
    channels.add("normal.X", 0, [&](std::size_t i) { return s.normal[i].x; });
    channels.add("normal.Y", 0, [&](std::size_t i) { return s.normal[i].y; });
    channels.add("normal.Z", 0, [&](std::size_t i) { return s.normal[i].z; });
    channels.add("depth.Z", 1, [&](std::size_t i) { return project(clip, toDouble(s.positionLocal[i])).z; });
    channels.add("receiver.A", 0, [](std::size_t) { return 1; });
}

void addLight(Channels& channels, const Picture& picture, std::size_t index, const RenderOptions& options)
{
    const ViewSamples& s = picture.samples;
    const Light& light = picture.shot.lights[index];
    const auto named = [&](const char* what, const char* channel) {
        return picture.shot.lights.size() == 1 ? fmt::format("{}.{}", what, channel)
                                               : fmt::format("{}.{}.{}", what, light.name, channel);
    };
    // As everywhere, what faces away is dark without a test.
    const auto faces = [&](std::size_t i) {
        return isLightFacing(light, s.originWorld, toDouble(s.positionLocal[i]), toDouble(s.normal[i]));
    };
    channels.add(named("visibility", "V"), 0,
                 [&](std::size_t i) { return faces(i) ? picture.visibility[index].value[i] : 0.0f; });
    if (options.withExact) {
        const std::vector<float> exact = exactVisibility(*picture.stage.traced, s, light);
        channels.add(named("exact", "V"), 0, [&](std::size_t i) { return exact[i]; });
    }
    if (!picture.plan) return;
    const ServedFootprints footprints(picture.view, s.originWorld, picture.plan->lights[index]);
    const auto at = [&](std::size_t i) { return footprints.at(toDouble(s.positionLocal[i]), toDouble(s.normal[i])); };
    if (options.withFootprint)
        channels.add(named("footprint", "S"), kNone, [&](std::size_t i) {
            const auto f = at(i);
            return f ? f->pixelsPerLixel : NAN;
        });
    if (options.withDensity)
        channels.add(named("density", "S"), kNone, [&](std::size_t i) {
            const auto f = at(i);
            return f ? f->lixelsPerPixel : NAN;
        });
}

void expectEnding(const std::string& path, std::string_view ending, std::string_view option)
{
    const std::string found = std::filesystem::path(path).extension().string();
    const bool isRight = std::equal(found.begin(), found.end(), ending.begin(), ending.end(),
                                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
    if (!found.empty() && !isRight)
        throw UsageError(fmt::format("{} \"{}\": expected a name that ends in {}", option, path, ending));
}

// What can be told before the scene is read.
void checkOptions(const RenderOptions& options)
{
    if (options.output.empty() && options.exr.empty() && options.plan.empty())
        throw UsageError("render: give -o PICTURE.png, --exr FILE.exr or --plan FILE.json");
    if (options.exr.empty() && (options.withExact || options.withFootprint || options.withDensity))
        throw UsageError("--exact, --footprint and --density are channels of --exr");
    expectEnding(options.output, ".png", "-o");
    expectEnding(options.exr, ".exr", "--exr");
    if (options.exr == "-") throw UsageError("--exr -: expected the name of a file");
    const std::pair<const char*, const std::string*> files[] = {
        {"-o", &options.output}, {"--exr", &options.exr}, {"--plan", &options.plan}};
    for (std::size_t i = 0; i < std::size(files); ++i)
        for (std::size_t j = i + 1; j < std::size(files); ++j)
            if (!files[i].second->empty() && !files[j].second->empty() &&
                isSameOutput(*files[i].second, *files[j].second))
                throw UsageError(fmt::format("{} and {}: expected two files", files[i].first, files[j].first));
    if (options.picture.view == "all") throw UsageError("--view all: render takes one view; lixel compare takes all");
    if (!options.output.empty()) expectWritable(options.output);
    if (!options.exr.empty()) expectWritable(options.exr);
    if (!options.plan.empty()) expectWritable(options.plan);
}

void renderShot(const RenderOptions& options, const Shooting& shooting, const TechniqueChoice& technique,
                const LixelBudget& lixels, Executor& executor)
{
    Progress progress("render", 4);
    progress.step("scene");
    const Shot& shot = shooting.shots.front();
    const Stage stage = makeStage(shooting.scene, shooting.evaluateOptions, originOf(shooting, shot));
    progress.step("view samples");
    Picture picture{shot, stage, shooting.planes, viewOf(shooting, shot), {}, {}, {}};
    picture.samples = executor.viewSamples(stage, picture.view);
    progress.step("shadows");
    addShadows(picture, executor, technique, lixels);
    progress.step("picture");
    StagedFiles files;
    const auto placeFor = [&](const std::string& path) { return path == "-" ? path : files.add(path).string(); };
    if (!options.output.empty()) {
        const auto pixels = executor.shade(stage, picture.view, shot.lights, picture.samples, picture.visibility);
        writeOrPrint(placeFor(options.output), encodePng(pixels));
    }
    if (!options.exr.empty()) {
        Channels channels(picture.samples);
        addSurfaces(channels, picture);
        for (std::size_t i = 0; i < shot.lights.size(); ++i) addLight(channels, picture, i, options);
        channels.write(placeFor(options.exr));
    }
    if (!options.plan.empty()) writeOrPrint(placeFor(options.plan), toPlanJson(*picture.plan, shot.lights));
    files.commit();
}

int runRender(const RenderOptions& options)
{
    const std::vector<TechniqueChoice> technique = readTechniques(options.technique);
    if (technique.size() != 1) throw UsageError("--technique: one technique is expected; lixel compare takes several");
    if ((options.withFootprint || options.withDensity || !options.plan.empty()) && !hasMap(technique.front().technique))
        throw UsageError(fmt::format("--footprint, --density and --plan: \"{}\" has no map", options.technique));
    const LixelBudget lixels = readBudget(options.lixels, "--lixels", kMostLixelsASide);
    checkOptions(options);
    const Shooting shooting = prepare(options.picture, false);
    expectPlanes(technique, shooting);
    renderShot(options, shooting, technique.front(), lixels, *makeExecutor(options.executor));
    tellWarnings(*shooting.scene);
    return kDone;
}

} // namespace

Command addRender(CLI::App& parent)
{
    auto o = std::make_shared<RenderOptions>();
    CLI::App* app = parent.add_subcommand("render", "a picture with shadows");
    addPictureOptions(*app, o->picture);
    app->add_option("-o,--output", o->output, "the picture, PNG; - for standard output");
    app->add_option("--technique", o->technique, "how shadows are made (lixel techniques)")->capture_default_str();
    app->add_option("--lixels", o->lixels,
                    "budget of each light, WIDTHxHEIGHT; several, split at commas: of its regions")
        ->capture_default_str();
    app->add_option("--executor", o->executor, "gl or trace")
        ->check(CLI::IsMember({"gl", "trace"}))
        ->capture_default_str();
    app->add_option("--exr", o->exr, "positions, normals, depth and visibility as float32 OpenEXR");
    app->add_option("--plan", o->plan, "what was planned, matrices and rectangles, as JSON that plan(file) reads");
    app->add_flag("--exact", o->withExact, "also exact visibility in the EXR");
    app->add_flag("--footprint", o->withFootprint, "also pixels per lixel (largest singular value) in the EXR");
    app->add_flag("--density", o->withDensity, "also lixels per pixel (by area) in the EXR");
    return {app, [o] { return runRender(*o); }};
}

} // namespace lixel::app
