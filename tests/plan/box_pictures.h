// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/visibility.h"
#include "lixel/plan/boundary_directions.h"
#include "lixel/plan/need.h"
#include "lixel/plan/observe.h"
#include "plan/random_setups.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

// What a camera sees of a set-up's boxes, and which of it is in shadow: exactly, ray by ray.
namespace lixel::test {

struct BoxHit
{
    double t;
    Vec3d normal;
};

// Where a ray enters the first box, beyond a little room.
inline std::optional<BoxHit> firstBox(const RandomSetup& setup, Vec3d fromLocal, Vec3d along)
{
    std::optional<BoxHit> first;
    const Vec3d from = fromLocal + setup.originWorld;
    for (const Box& box : setup.boxesWorld) {
        double enter = 1e-9, leave = INFINITY;
        Vec3d normal;
        const auto slab = [&](double p, double d, double low, double high, Vec3d axis) {
            const double near = (d > 0 ? low - p : high - p) / d, far = (d > 0 ? high - p : low - p) / d;
            if (d == 0) {
                if (p < low || p > high) leave = -1;
                return;
            }
            if (near > enter) enter = near, normal = d > 0 ? -axis : axis;
            leave = std::min(leave, far);
        };
        slab(from.x, along.x, box.min.x, box.max.x, {1, 0, 0});
        slab(from.y, along.y, box.min.y, box.max.y, {0, 1, 0});
        slab(from.z, along.z, box.min.z, box.max.z, {0, 0, 1});
        if (enter < leave && dot(normal, normal) > 0 && (!first || enter < first->t)) first = BoxHit{enter, normal};
    }
    return first;
}

struct BoxPicture
{
    ViewSamples seen;
    Visibility lit;
    std::vector<Vec3d> facingLocal;
};

inline BoxPicture boxPicture(const RandomSetup& setup)
{
    const Mat4d back = inverse(clipFromLocal(setup.view, setup.originWorld)).value();
    BoxPicture out;
    ViewSamples& seen = out.seen;
    seen.width = setup.view.width, seen.height = setup.view.height, seen.originWorld = setup.originWorld;
    for (int y = 0; y < seen.height; ++y)
        for (int x = 0; x < seen.width; ++x) {
            const Vec2d ndc{(2 * x + 1.0) / seen.width - 1, (2 * y + 1.0) / seen.height - 1};
            const Vec3d near = project(back, {ndc.x, ndc.y, -1}), beyond = project(back, {ndc.x, ndc.y, 0.5});
            const Vec3d along = normalized(beyond - near);
            const auto hit = firstBox(setup, near, along);
            if (!hit) continue;
            const Vec3d p = near + hit->t * along;
            const Vec4d clip = clipFromLocal(setup.view, setup.originWorld) * point(p);
            if (!(clip.z < clip.w)) continue;
            seen.pixel.push_back({float(x) + 0.5f, float(y) + 0.5f});
            seen.positionLocal.push_back(toFloat(p));
            seen.normal.push_back(toFloat(hit->normal));
            seen.triangle.push_back(0);
            const bool isFacing = isLightFacing(setup.light, setup.originWorld, p, hit->normal);
            if (isFacing) out.facingLocal.push_back(toDouble(seen.positionLocal.back()));
            bool isLit = isFacing;
            if (isFacing) {
                const Vec3d toLight = towardsLight(setup.light, setup.originWorld, p);
                const auto blocked = firstBox(setup, p + 1e-6 * setup.radius * hit->normal, toLight);
                isLit = !blocked || (setup.light.kind != LightKind::Directional &&
                                     blocked->t > length(setup.light.positionWorld - setup.originWorld - p));
            }
            out.lit.value.push_back(isLit ? 1.0f : 0.0f);
        }
    return out;
}

// The samples near shadow boundaries, as planning gathers them.
inline std::vector<NeedSample> edgesOf(const RandomSetup& setup, const BoxPicture& picture,
                                       double awayFromBoundaries = 0.002)
{
    const Observation observed =
        observe(picture.seen, setup.view, {&setup.light, 1}, {&picture.lit, 1}, gridWithin({}, setup.view));
    NeedSource source;
    source.observed = &observed;
    source.view = &setup.view;
    BoundaryDirections directions;
    std::vector<NeedSample> out;
    gatherNeedSamples(source, setup.light, setup.originWorld, directions, out,
                      {1u << 16, 1u << 16, awayFromBoundaries, true});
    return out;
}

} // namespace lixel::test
