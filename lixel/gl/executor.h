// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/caster_source.h"
#include "lixel/base/expected.h"
#include "lixel/base/image.h"
#include "lixel/base/light.h"
#include "lixel/base/observation.h"
#include "lixel/base/view.h"
#include "lixel/base/view_samples.h"
#include "lixel/base/visibility.h"
#include "lixel/gl/graphics_error.h"
#include "lixel/gl/volume_failure.h"
#include "lixel/plan/partition/sdsm_fill.h"
#include "lixel/plan/shadow_plan.h"
#include "lixel/plan/warp/warp_fill.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lixel {

// What a frame costs, medians. A frame is: view, gather, sdsm and importance if tables are to be made, light depth, lookup, and as asked for
// sample and shade; in a loop also readback, else nothing is read back in it.
struct FrameTimes
{
    struct Pass
    {
        std::string name;
        double ms = 0;
    };
    double frameMs = 0;          // of undisturbed frames, from an idle device to an idle device, by the steady clock
    std::optional<double> gpuMs; // by timer queries; nothing on software drivers, where they see next to nothing
    std::vector<Pass> passes;    // of separate frames, in their order
    std::string clock;           // what the passes were timed by
    // Of casters in buffers: triangles times the regions they were drawn into, and those times the regions that could not see
    // them.
    std::uint64_t trianglesDrawn = 0, trianglesCulled = 0;
};

// The executor on OpenGL 4.5 core: does what a plan says on the device, and decides nothing about shadows. It owns its passes and
// textures, which grow with the frame: after the first frame of a size no OpenGL object is made. It belongs to one thread.
//
// Plan, casters and samples share their originWorld; casters of version 0 are uploaded again at every call. Whatever fails
// on the device throws gl::GraphicsError with one clear line; nothing falls back by itself.
class GlExecutor
{
public:
    enum class Context {
        Headless, // a context of its own, without a window system or a display
        Current   // the host's, current on this thread at every call; state that passes set is not put back
    };
    explicit GlExecutor(Context context = Context::Headless);
    ~GlExecutor();
    GlExecutor(GlExecutor&&) noexcept;
    GlExecutor& operator=(GlExecutor&&) noexcept;

    const std::string& renderer() const;
    bool isSoftware() const;

    // Regions drawn so far. Maps of a plan stay: those that the next plan has too, of casters of the same version (which is not 0), in
    // an atlas of the same size, are not drawn again, unless they are forgotten: measuring, one does as if casters had moved.
    // What lookups prepare from maps stays with them; plansPrepared() counts how often it was made.
    std::uint64_t mapsDrawn() const;
    std::uint64_t plansPrepared() const;
    void forgetMaps();

    // Bytes on the device of all buffers and textures that this thread's executors have.
    std::uint64_t deviceBytes() const;

    // Bytes on the device that warps take besides their knots: what making them there needs, and then exact drawing in the same room.
    std::size_t warpBytes() const;

    void finish(); // waits until the device has done all that it was asked for

    // What the view sees: one sample a pixel centre, row by row from the bottom; pixels that see nothing have none.
    ViewSamples viewSamples(const CasterBuffers& casters, const View& view);

    // Draws the maps of a plan and looks the samples up in them. One Visibility a light.
    std::vector<Visibility> run(const FramePlan& plan, const CasterSource& casters, const ViewSamples& samples);

    // The maps of a plan, one image a layer: 1 near, 0 far and empty.
    std::vector<Image<float>> drawMaps(const FramePlan& plan, const CasterSource& casters);

    // What the lixels of such maps really sample: the Local position of the surface drawn in each, as the device interpolates it,
    // with w = 1; w = 0 where nothing is. For measuring; the casters have no holes.
    std::vector<Image<Vec4f>> drawPositions(const FramePlan& plan, const CasterBuffers& casters);

    // The same maps left on the device, for a host that looks them up with its own shaders (lixel_lookup.glsl): the OpenGL name of
    // a 2D array texture of 32-bit float depth, 1 near, 0 far and empty, row 0 at the bottom. It stays the executor's, and is
    // good until the next call.
    std::uint32_t drawAtlas(const FramePlan& plan, const CasterSource& casters);

    // Visibility without a map: by shadow volumes, whose truth is the rasterizer's. Samples stand at the centres of pixels of the
    // view, at most one in each. One Visibility a light.
    Expected<std::vector<Visibility>, VolumeFailure> shadowVolumes(const CasterBuffers& casters, const View& view,
                                                                   std::span<const Light> lights,
                                                                   const ViewSamples& samples);

    // The picture with visibility from anywhere, one Visibility a light: a pixel takes the weighted mean of its samples, and is
    // lit where it has none; so is everything where a light's values are empty. Row 0 is the bottom.
    Image<Rgba8> shade(const CasterBuffers& casters, const View& view, std::span<const Light> lights,
                       const ViewSamples& samples, std::span<const Visibility> visibility);

    // A whole frame on the device, as a renderer would draw it; only the picture is read back.
    struct Frame
    {
        const CasterBuffers& seen;
        const CasterSource& casters;
        const View& view;
        const FramePlan& plan;
        std::span<const Light> lights; // of the plan; empty: measure() leaves the shade pass out
        std::optional<ObservationGrid> observed =
            std::nullopt;                     // nothing: measure() and advance() leave the sample pass out
        std::span<const SdsmFill> fills = {}; // of a layout: tables that are made on the device from what is seen
        std::span<const WarpFill> warps = {}; // likewise; they need the lights
    };
    Image<Rgba8> render(const Frame& frame);

    // What the view sees, at low resolution, and with a frame which lights reach it: of age 0, so it waits for the device. Without
    // `observed` the grid is the usual one.
    Observation observe(const CasterBuffers& casters, const View& view, ObservationGrid grid = {});
    Observation observe(const Frame& frame);

    // One frame of a loop, drawn like render()'s, but the picture stays on the device. What was observed in the frame
    // kObservationAge calls before, always that one, goes into `observation`, in the storage it has; false, and nothing is
    // changed, where that frame was not observed and in the first calls of a loop. Where the host runs no more frames ahead of
    // the device than this, nothing is waited for. `passes`: where given, each is timed, which disturbs the frame.
    static constexpr int kObservationAge = 2;
    bool advance(const Frame& frame, Observation& observation, std::vector<FrameTimes::Pass>* passes = nullptr);
    const char* passClock() const;       // what passes are timed by
    void restart();                      // the next advance() is the first of a loop
    std::uint64_t readbackWaits() const; // calls of advance() that met an observation which was still on its way

    // Draws the frame, and its maps each time, twice to warm up, then `frames` times undisturbed and `frames` times pass by pass.
    FrameTimes measure(const Frame& frame, int frames = 15);

    // The same of a frame with shadow volumes, of casters whose edges are known; without culling. Shaded where asked for.
    Expected<FrameTimes, VolumeFailure> measureVolumes(const CasterBuffers& casters, const View& view,
                                                       std::span<const Light> lights, bool isShaded, int frames = 15);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lixel
