// SPDX-License-Identifier: MIT
//
// opengl_host [--technique TEXT] [--lixels WxH] [--size WxH] [--casters own|callback|both] [--scene FILE.obj] [-o FILE.png]
//
// A renderer that knew nothing of lixel asks it where its shadow maps go, and draws them itself ("own"), or lets lixel's
// OpenGL executor draw them and is called back for its casters ("callback"). "both" does one after the other and compares:
// the pictures are nearly the same, or it fails. Exit code 4: there is no OpenGL 4.5.
#include "context.h"
#include "renderer.h"

#include <lixel/gl/executor.h>
#include <lixel/plan/host_matrix.h>
#include <lixel/plan/host_view.h>

#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>

using namespace lixel;

namespace {

struct Options
{
    std::string technique = "cube+focused+pcf(9)", casters = "both", scene = HOST_FOLDER "/courtyard.obj", output;
    LixelSize lixels{1024, 1024}, size{960, 540};
};

LixelSize sizeOf(const char* text)
{
    LixelSize size;
    if (std::sscanf(text, "%dx%d", &size.width, &size.height) != 2 || size.width < 1 || size.height < 1)
        throw std::runtime_error(std::string("\"") + text + "\" is not WIDTHxHEIGHT");
    return size;
}

Options parse(int argc, char** argv)
{
    Options options;
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        if (i + 1 == argc) throw std::runtime_error(name + " needs a value");
        const char* value = argv[i + 1];
        if (name == "--technique") options.technique = value;
        else if (name == "--casters") options.casters = value;
        else if (name == "--scene") options.scene = value;
        else if (name == "--lixels") options.lixels = sizeOf(value);
        else if (name == "--size") options.size = sizeOf(value);
        else if (name == "-o") options.output = value;
        else throw std::runtime_error(name + " is not known");
    }
    if (options.casters != "own" && options.casters != "callback" && options.casters != "both")
        throw std::runtime_error("--casters is own, callback or both");
    return options;
}

// The host's camera and its matrices, in the host's convention: depth near / distance, infinitely far.
View hostCamera(LixelSize size)
{
    const Vec3d eyeWorld{8.2, 6.0, 12.5};
    const Mat4d viewFromWorld =
        eyeFromWorldRotation(Vec3d{-1.2, 1.1, -1.5} - eyeWorld, {0, 1, 0}) * translation(-eyeWorld);
    const double focal = 1.7, near = 0.1, aspect = double(size.width) / size.height;
    const Mat4d clipFromView =
        Mat4d::fromRows({focal / aspect, 0, 0, 0}, {0, focal, 0, 0}, {0, 0, 0, near}, {0, 0, -1, 0});
    return viewFromHost(clipFromView, viewFromWorld, kHostClip, size.width, size.height).value();
}

std::vector<Light> hostLights()
{
    Light sun, spot, lantern;
    sun.name = "sun";
    sun.directionWorld = normalized({-0.62, -0.78, -0.35});
    sun.colour = {0.8, 0.7, 0.55};

    spot.name = "spot";
    spot.kind = LightKind::Spot;
    spot.positionWorld = {-6.5, 6.5, 4};
    spot.directionWorld = normalized({1, -1.25, -0.75});
    spot.coneAngle = 0.9;
    spot.range = 22;
    spot.colour = {4.0, 2.4, 1.2};

    lantern.name = "lantern"; // within the scene, behind the columns
    lantern.kind = LightKind::Point;
    lantern.positionWorld = {1.8, 2.4, -6.2};
    lantern.range = 14;
    lantern.colour = {0.8, 1.5, 3.0};
    return {sun, spot, lantern};
}

MapTechnique techniqueOf(const std::string& text)
{
    const Expected<Technique, std::string> technique = parseTechnique(text);
    if (!technique) throw std::runtime_error(technique.error());
    const MapTechnique* maps = std::get_if<MapTechnique>(&*technique);
    if (maps && warpOptionsOf(maps->warp))
        throw std::runtime_error("technique \"" + text + "\" warps its maps, which this host does not draw");
    if (maps) return *maps;
    throw std::runtime_error("technique \"" + text + "\" has no map to draw");
}

void print(const FramePlan& plan, std::span<const Light> lights)
{
    std::printf("atlas: %d layers of %d x %d\n", plan.layers, plan.atlas.width, plan.atlas.height);
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (const auto& refused = plan.lights[i].refused)
            std::printf("%s: no map, %s\n", lights[i].name.c_str(), std::string(sentenceFor(*refused)).c_str());
        else
            std::printf("%s: %zu regions, %lld lixels\n", lights[i].name.c_str(), plan.lights[i].regions.size(),
                        static_cast<long long>(plan.lixelsOf(i)));
}

void run(const Options& options)
{
    const MapTechnique technique = techniqueOf(options.technique);
    const std::vector<HostMesh> meshes = loadObj(options.scene);
    const View view = hostCamera(options.size);
    const std::vector<Light> lights = hostLights();
    Renderer renderer(meshes, view.anchorWorld, options.size.width, options.size.height);

    std::vector<Box> boxesWorld;
    for (const HostMesh& mesh : meshes) boxesWorld.push_back(mesh.boxWorld);
    ViewSamples seen;
    if (needsViewSamples(technique)) seen = renderer.see(view);
    // What planes(ground) means in this world.
    const std::vector<NamedPlane> planes{{"ground", {0, 0, 0}, {0, 1, 0}, {}}};
    const FramePlan plan = planShadows({.view = view,
                                        .lights = lights,
                                        .casterBoxesWorld = boxesWorld,
                                        .originWorld = view.anchorWorld,
                                        .technique = technique,
                                        .lixels = options.lixels,
                                        .seen = seen.size() ? &seen : nullptr,
                                        .planes = planes});
    print(plan, lights);

    Picture own, called;
    if (options.casters != "callback") own = renderer.draw(view, plan, lights, renderer.drawShadowMaps(plan));
    if (options.casters != "own") {
        GlExecutor executor(GlExecutor::Context::Current);
        called = renderer.draw(view, plan, lights, executor.drawAtlas(plan, renderer.casters()));
    }
    if (!options.output.empty()) writePng(options.output, options.casters == "callback" ? called : own);
    if (options.casters != "both") return;
    const double share = shareDiffering(own, called, 2);
    std::printf("own maps against lixel's executor: %.4f %% of pixels differ\n", 100 * share);
    if (!(share < 1e-3)) throw std::runtime_error("the pictures differ");
}

} // namespace

int main(int argc, char** argv)
{
    try {
        const Options options = parse(argc, argv);
        if (!makeContext()) {
            std::fprintf(stderr, "opengl_host: no OpenGL 4.5 without a window system here\n");
            return 4;
        }
        run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "opengl_host: %s\n", error.what());
        return 1;
    }
}
