// SPDX-License-Identifier: MIT
#include "commands.h"
#include "comparison.h"
#include "exit_code.h"
#include "lixel/plan/footprint.h"
#include "lixel/report/exr.h"
#include "lixel/report/json.h"
#include "lixel/report/png.h"
#include "lixel/scene/framing.h"
#include "lixel/trace/exact_area.h"
#include "lixel/trace/exact_visibility.h"
#include "lixel/trace/trace_scene.h"
#include "run_results.h"
#include "text.h"

#include <cstdio>
#include <limits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace lixel::app {
namespace {

struct RenderOptions
{
    PictureOptions picture;
    std::string output, exr;
    std::string technique = "focused+pcf(9)";
    std::string lixels = "2048x2048";
    std::string executor = "gl";
    bool withExact = false, withFootprint = false, withDensity = false;
};

// Everything known of one picture.
struct Picture
{
    const Shot& shot;
    const Stage& stage;
    View view;
    ViewSamples samples;
    std::vector<Visibility> visibility;
    std::optional<FramePlan> plan;
};

std::vector<Visibility> visibilityOf(Picture& picture, Executor& executor, const TechniqueChoice& choice, LixelSize lixels)
{
    if (const auto* map = std::get_if<MapTechnique>(&choice.technique)) {
        picture.plan = planShadows({picture.view, picture.shot.lights, picture.stage.buffers.bounds.boxesWorld,
                                    picture.stage.buffers.triangles.originWorld, *map, lixels});
        for (std::size_t i = 0; i < picture.shot.lights.size(); ++i)
            if (const auto& refused = picture.plan->lights[i].refused)
                throw RefusedError(fmt::format("{}: light \"{}\": refused: {} ({})", choice.typed, picture.shot.lights[i].name,
                                               sentenceFor(*refused), nameOf(*refused)));
        return executor.run(picture.stage, *picture.plan, picture.samples);
    }
    std::vector<Visibility> out;
    for (const Light& light : picture.shot.lights) {
        if (const auto* area = std::get_if<ExactAreaTechnique>(&choice.technique))
            out.push_back({exactArea(*picture.stage.traced, picture.view, picture.samples, light, area->samples), {}});
        else
            out.push_back({exactVisibility(*picture.stage.traced, picture.samples, light), {}});
    }
    return out;
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

void writeChannels(const RenderOptions& options, const Picture& picture)
{
    const ViewSamples& s = picture.samples;
    const Mat4d clip = clipFromLocal(picture.view, s.originWorld);
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    Channels channels(s);
    channels.add("position.X", kNone, [&](std::size_t i) { return s.positionLocal[i].x; });
    channels.add("position.Y", kNone, [&](std::size_t i) { return s.positionLocal[i].y; });
    channels.add("position.Z", kNone, [&](std::size_t i) { return s.positionLocal[i].z; });
    channels.add("normal.X", 0, [&](std::size_t i) { return s.normal[i].x; });
    channels.add("normal.Y", 0, [&](std::size_t i) { return s.normal[i].y; });
    channels.add("normal.Z", 0, [&](std::size_t i) { return s.normal[i].z; });
    channels.add("depth.Z", 1, [&](std::size_t i) { return project(clip, toDouble(s.positionLocal[i])).z; });
    channels.add("receiver.A", 0, [](std::size_t) { return 1; });
    const auto& lights = picture.shot.lights;
    for (std::size_t light = 0; light < lights.size(); ++light) {
        const auto named = [&](const char* what, const char* channel) {
            return lights.size() == 1 ? fmt::format("{}.{}", what, channel) : fmt::format("{}.{}.{}", what, lights[light].name, channel);
        };
        // As everywhere, what faces away is dark without a test.
        const auto faces = [&](std::size_t i) {
            return isLightFacing(lights[light], s.originWorld, toDouble(s.positionLocal[i]), toDouble(s.normal[i]));
        };
        channels.add(named("visibility", "V"), 0, [&](std::size_t i) { return faces(i) ? picture.visibility[light].value[i] : 0.0f; });
        if (options.withExact) {
            const std::vector<float> exact = exactVisibility(*picture.stage.traced, s, lights[light]);
            channels.add(named("exact", "V"), 0, [&](std::size_t i) { return exact[i]; });
        }
        if (!picture.plan) continue;
        const PlannedRegion& region = picture.plan->lights[light].regions.front();
        const LightImage image(region.lightClipFromLocal, region.rectangle);
        const auto at = [&](std::size_t i) {
            return footprint(picture.view, s.originWorld, image, toDouble(s.positionLocal[i]), toDouble(s.normal[i]));
        };
        if (options.withFootprint)
            channels.add(named("footprint", "S"), kNone, [&](std::size_t i) { const auto f = at(i); return f ? f->pixelsPerLixel : NAN; });
        if (options.withDensity)
            channels.add(named("density", "S"), kNone, [&](std::size_t i) { const auto f = at(i); return f ? f->lixelsPerPixel : NAN; });
    }
    channels.write(options.exr);
}

int runRender(const RenderOptions& options)
{
    const std::vector<TechniqueChoice> technique = readTechniques(options.technique);
    if (technique.size() != 1) throw UsageError("--technique: one technique is expected; lixel compare takes several");
    const LixelSize lixels = readSize(options.lixels, "--lixels", kMostLixelsASide);
    if (options.output.empty() && options.exr.empty()) throw UsageError("render: give -o PICTURE.png or --exr FILE.exr");
    if (options.exr.empty() && (options.withExact || options.withFootprint || options.withDensity))
        throw UsageError("--exact, --footprint and --density are channels of --exr");
    if (options.picture.view == "all") throw UsageError("--view all: render takes one view; lixel compare takes all");
    const Shooting shooting = prepare(options.picture, false);
    const auto executor = makeExecutor(options.executor);
    Progress progress("render", 4);
    progress.step("scene");
    const Shot& shot = shooting.shots.front();
    const Stage stage = makeStage(shooting.scene, shooting.evaluateOptions, chooseOrigin(shot.camera.eyeWorld, shooting.sceneWorld));
    progress.step("view samples");
    Picture picture{shot, stage, makeView(shot.camera, shooting.width, shooting.height, shooting.sceneWorld), {}, {}, {}};
    picture.samples = executor->viewSamples(stage, picture.view);
    progress.step("shadows");
    picture.visibility = visibilityOf(picture, *executor, technique.front(), lixels);
    progress.step("picture");
    if (!options.output.empty())
        writePng(options.output, executor->shade(stage, picture.view, shot.lights, picture.samples, picture.visibility));
    if (!options.exr.empty()) writeChannels(options, picture);
    return kDone;
}

} // namespace

Command addRender(CLI::App& parent)
{
    auto o = std::make_shared<RenderOptions>();
    CLI::App* app = parent.add_subcommand("render", "a picture with shadows");
    addPictureOptions(*app, o->picture);
    app->add_option("-o,--output", o->output, "the picture, PNG");
    app->add_option("--technique", o->technique, "how shadows are made (lixel techniques)")->capture_default_str();
    app->add_option("--lixels", o->lixels, "budget of each light, WIDTHxHEIGHT")->capture_default_str();
    app->add_option("--executor", o->executor, "gl or trace")->check(CLI::IsMember({"gl", "trace"}))->capture_default_str();
    app->add_option("--exr", o->exr, "positions, normals, depth and visibility as float32 OpenEXR");
    app->add_flag("--exact", o->withExact, "also exact visibility in the EXR");
    app->add_flag("--footprint", o->withFootprint, "also pixels per lixel (largest singular value) in the EXR");
    app->add_flag("--density", o->withDensity, "also lixels per pixel (by area) in the EXR");
    return {app, [o] { return runRender(*o); }};
}

} // namespace lixel::app
