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
        depthPass.run(plan, tables, surfaces, atlas, culling);
    } else {
        depthPass.run(plan, tables, std::get<CasterCallback>(casters), atlas, culling);
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
    if (plan.lookup.isPrepared()) preparePass.run(plan, tables, atlas, prepared);
    lookupPass.run(plan, tables, {atlas, prepared}, points, visibility);
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

std::optional<FramePlan> planOfQuarters(const Box& boxWorld, const View& view, const Light& light, Vec3d originWorld,
                                        LixelSize lixels)
{
    FramePlan plan;
    plan.atlas = {2 * lixels.width, 2 * lixels.height};
    plan.layers = 1;
    plan.lights.resize(1);
    plan.originWorld = originWorld;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const int i = quarter % 2, j = quarter / 2;
        const double x = 1 - 2 * i, y = 1 - 2 * j; // of NDC, a quarter becomes the whole
        View part = view;
        part.clipFromAnchored =
            Mat4d::fromRows({2, 0, 0, x}, {0, 2, 0, y}, {0, 0, 1, 0}, {0, 0, 0, 1}) * view.clipFromAnchored;
        const FramePlan alone = planShadows({part, {&light, 1}, {&boxWorld, 1}, originWorld, {}, lixels});
        if (alone.lights[0].refused) return std::nullopt;
        plan.lookup = alone.lookup;
        PlannedRegion region = alone.lights[0].regions[0];
        const int x0 = i * lixels.width, y0 = j * lixels.height;
        region.rectangle = {x0, y0, x0 + lixels.width, y0 + lixels.height, 0};
        plan.lights[0].regions.push_back(region);
        shared::ShadowRegion row = alone.regionTable[0];
        row.lixelFromNdc.z += float(x0), row.lixelFromNdc.w += float(y0);
        row.rectangle = {float(x0), float(y0), float(x0 + lixels.width), float(y0 + lixels.height)};
        row.place = {0, float(plan.halfSpaceTable.size()), 2, 0};
        plan.regionTable.push_back(row);
        const Mat4d clip = clipFromLocal(view, originWorld);
        for (const Vec4d& side : {-x * clip.row(0), -y * clip.row(1)})
            plan.halfSpaceTable.push_back({float(side.x), float(side.y), float(side.z), float(side.w)});
    }
    shared::ShadowLight lightRow;
    lightRow.regions = {0, 4, 1, 0};
    plan.lightTable.push_back(lightRow);
    return plan;
}

} // namespace lixel::test
