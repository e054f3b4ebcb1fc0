// SPDX-License-Identifier: MIT
#include "shadow_drawer.h"

#include <epoxy/gl.h>

namespace lixel::test {

TracedAtlas ShadowDrawer::drawAtlas(const FramePlan& plan, const CasterSource& casters)
{
    tables.upload(plan);
    atlas.resize(device, plan);
    if (const CasterBuffers* buffers = std::get_if<CasterBuffers>(&casters)) {
        surfaces.update(*buffers);
        depthPass.run(plan, tables, surfaces, atlas);
    } else {
        depthPass.run(plan, tables, std::get<CasterCallback>(casters), atlas);
    }
    return atlas.download(plan.layers);
}

void ShadowDrawer::writeAtlas(const FramePlan& plan, const TracedAtlas& maps)
{
    tables.upload(plan);
    atlas.resize(device, plan);
    for (std::size_t layer = 0; layer < maps.size(); ++layer)
        glTextureSubImage3D(atlas.depth.name(), 0, 0, 0, GLint(layer), maps[layer].width(), maps[layer].height(), 1,
                            GL_DEPTH_COMPONENT, GL_FLOAT, maps[layer].data().data());
}

std::vector<Visibility> ShadowDrawer::lookUp(const FramePlan& plan, const ViewSamples& samples)
{
    points.upload(samples);
    lookupPass.run(plan, tables, atlas, points, visibility);
    return visibility.download();
}

Light anyLightOn(Rng& rng, Vec3d centreWorld, double half, double least, double most)
{
    Light light;
    light.kind = LightKind(rng.integer(0, 2));
    const Vec3d from = normalized(rng.onSphere() + Vec3d{0, 1.3, 0});
    light.positionWorld = centreWorld + rng.logUniform(least, most) * half * from;
    light.directionWorld = normalized(centreWorld - light.positionWorld);
    light.coneAngle = rng.uniform(0.5, 1.5);
    return light;
}

FramePlan planFor(const SmallScene& scene, const View& view, std::span<const Light> lights, LixelSize lixels,
                  const MapTechnique& technique)
{
    const Box box = scene.boxWorld();
    return planShadows({view, lights, {&box, 1}, scene.originWorld, technique, lixels});
}

} // namespace lixel::test
