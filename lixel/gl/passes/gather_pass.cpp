// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/gather_pass.h"

#include "lixel/base/assert.h"
#include "lixel/shared/gl_slots.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <span>

namespace lixel::gl {
namespace {

// Locations in gather.comp.glsl.
constexpr int kFirstPoint = 0, kPointCount = 1, kFirstTriangle = 2, kTriangleCount = 3;

shared::dvec4 toShared(Vec4d v) { return {v.x, v.y, v.z, v.w}; }
shared::dvec4 toShared(Vec3d v) { return {v.x, v.y, v.z, 0}; }

} // namespace

shared::ViewRays raysOf(const View& view, Vec3d originWorld)
{
    const Mat4d clip = clipFromLocal(view, originWorld);
    const Vec3d rowX = xyz(clip.row(0)), rowY = xyz(clip.row(1)), rowW = xyz(clip.row(3));
    shared::ViewRays rays;

    // A point with NDC (x, y) lies in the planes rowX - x rowW and rowY - y rowW: its ray runs along the cross product of
    // their normals, which has no term in x y.
    const Vec3d along = cross(rowX, rowY);
    rays.rayDirection[0] = toShared(along);
    rays.rayDirection[1] = toShared(cross(rowY, rowW));
    rays.rayDirection[2] = toShared(cross(rowW, rowX));

    // Rays start at the eye; parallel ones where they are nearest to the origin, where floats are finest.
    const Vec4d eye = eyeLocal(view, originWorld);
    if (eye.w != 0) {
        rays.rayOrigin[0] = toShared(xyz(eye) / eye.w);
    } else {
        const std::optional<Mat4d> localFromClip = inverse(clip);
        LX_ASSERT(localFromClip.has_value());
        const auto nearest = [&](Vec4d inClip) { // a point or a difference of points
            const Vec3d p = xyz(*localFromClip * inClip);
            return toShared(p - dot(p, along) / dot(along, along) * along);
        };
        const double w = clip.m[3][3]; // of every point
        rays.rayOrigin[0] = nearest({0, 0, 0, w});
        rays.rayOrigin[1] = nearest({w, 0, 0, 0});
        rays.rayOrigin[2] = nearest({0, w, 0, 0});
    }
    rays.clipW = toShared(clip.row(3));
    rays.eyeLocal = toShared(eye);
    return rays;
}

GatherPass::GatherPass() : program_(Program::compute("gather.comp.glsl")) {}

void GatherPass::run(const Surfaces& surfaces, const View& view, const ViewTargets& targets, PointList& points)
{
    const shared::ViewRays rays = raysOf(view, surfaces.originWorld());
    rays_.assign(std::span<const shared::ViewRays>(&rays, 1));
    rays_.bindUniform(shared::kUniformView, sizeof(rays));
    points.resizeToPixels(view.width, view.height, surfaces.originWorld());
    targets.triangles.bind(shared::kUnitTriangles);
    program_.use();

    // Every part of the list against every part of the triangles; each entry is written by the part that has its triangle,
    // and by all of them where there is none.
    for (const PointList::Part& part : points.parts()) {
        points.bind(part);
        program_.set(kFirstPoint, std::uint32_t(part.first));
        program_.set(kPointCount, std::uint32_t(part.count));
        std::uint32_t first = 0;
        do {
            const std::uint32_t count = std::min(surfaces.triangleCount() - first, surfaces.trianglesPerBinding());
            surfaces.bindTriangles(first, count);
            program_.set(kFirstTriangle, first);
            program_.set(kTriangleCount, count);
            glDispatchCompute(GLuint((part.count + 63) / 64), 1, 1);
            first += count;
        } while (first < surfaces.triangleCount());
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

} // namespace lixel::gl
