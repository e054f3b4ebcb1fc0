// SPDX-License-Identifier: MIT
#pragma once

#include "mesh.h"
#include "picture.h"

#include <lixel/base/caster_source.h>
#include <lixel/base/view_samples.h>
#include <lixel/plan/clip_convention.h>
#include <lixel/plan/shadow_plan.h>

#include <span>
#include <string>
#include <vector>

// This host draws with depth reversed in 0..1 and y up; row 0 of its textures is at the bottom.
inline constexpr lixel::ClipConvention kHostClip{lixel::ClipDepth::OneToZero, false};
inline constexpr lixel::TextureOrigin kHostOrigin = lixel::TextureOrigin::Bottom;

// A small forward renderer. Its objects live as long as the context, that is, as long as the program.
class Renderer
{
public:
    Renderer(std::span<const HostMesh> meshes, lixel::Vec3d originWorld, int width, int height);

    // What the view sees, a sample a pixel, read back. A real renderer takes a small picture of an earlier frame.
    lixel::ViewSamples see(const lixel::View& view) const;

    // Own shadow maps: the plan's regions, each drawn with this renderer's program into its rectangle of an own texture, whose
    // name comes back.
    unsigned drawShadowMaps(const lixel::FramePlan& plan);

    // The same casters, to be drawn when lixel's executor asks for them.
    lixel::CasterCallback casters() const;

    // The picture, its shadows from an atlas drawn by either.
    Picture draw(const lixel::View& view, const lixel::FramePlan& plan, std::span<const lixel::Light> lights,
                 unsigned atlas);

private:
    struct MeshOnDevice
    {
        lixel::Box boxLocal;
        unsigned vertexArray = 0;
        int vertexCount = 0;
    };
    void drawMesh(const MeshOnDevice& mesh, unsigned program, int instances) const;
    void drawInto(unsigned framebuffer, const lixel::View& view, unsigned program) const;
    void drawForLixel(std::span<const lixel::CasterView> views) const;

    lixel::Vec3d originWorld_;
    int width_ = 0, height_ = 0;
    std::vector<MeshOnDevice> meshes_;
    unsigned sceneProgram_ = 0, surfaceProgram_ = 0, depthProgram_ = 0, casterProgram_ = 0;
    unsigned pictureFramebuffer_ = 0, surfaceFramebuffer_ = 0, atlasFramebuffer_ = 0, atlas_ = 0;
    unsigned tables_[4] = {}; // regions, half-spaces, lights of the plan; own lights
};
