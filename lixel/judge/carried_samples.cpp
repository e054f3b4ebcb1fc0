// SPDX-License-Identifier: MIT
#include "lixel/judge/carried_samples.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace lixel {
namespace {

using Corners3 = std::array<Vec3f, 3>;

std::array<std::uint32_t, 3> cornerIndices(const LocalTriangles& triangles, std::size_t triangle)
{
    const std::uint32_t* at = triangles.indices.data() + 3 * triangle;
    return {at[0], at[1], at[2]};
}

Corners3 cornersOf(const LocalTriangles& triangles, std::size_t triangle)
{
    const auto [a, b, c] = cornerIndices(triangles, triangle);
    return {triangles.positionLocal[a], triangles.positionLocal[b], triangles.positionLocal[c]};
}

// From the triangles of one moment to those of another.
class SameTriangles
{
public:
    SameTriangles(const LocalTriangles& before, const LocalTriangles& now)
        : before_(before), now_(now), isSameList_(before.indices == now.indices)
    {
        if (isSameList_) return;
        byCorners_.resize(now.triangleCount());
        std::iota(byCorners_.begin(), byCorners_.end(), std::uint32_t(0));
        std::stable_sort(byCorners_.begin(), byCorners_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return cornerIndices(now, a) < cornerIndices(now, b);
        });
    }

    std::optional<std::uint32_t> at(std::uint32_t triangleBefore) const
    {
        if (isSameList_) return triangleBefore;
        if (before_.positionLocal.size() != now_.positionLocal.size()) return std::nullopt; // another scene
        const auto wanted = cornerIndices(before_, triangleBefore);
        const auto found = std::lower_bound(
            byCorners_.begin(), byCorners_.end(), wanted,
            [&](std::uint32_t triangle, const auto& corners) { return cornerIndices(now_, triangle) < corners; });
        if (found == byCorners_.end() || cornerIndices(now_, *found) != wanted) return std::nullopt;
        return *found;
    }

private:
    const LocalTriangles& before_;
    const LocalTriangles& now_;
    bool isSameList_;
    std::vector<std::uint32_t> byCorners_; // triangles of now_
};

struct SurfacePlace
{
    Vec3f positionLocal, normal;
};

// A point of one triangle at the same weights of another's corners. Nothing where either has no area.
std::optional<SurfacePlace> moved(const SurfacePlace& place, const Corners3& from, const Corners3& to)
{
    if (from == to) return place;
    const Vec3d a = toDouble(from[0]), ab = toDouble(from[1]) - a, ac = toDouble(from[2]) - a;
    const Vec3d p = toDouble(place.positionLocal) - a, across = cross(ab, ac);
    const double squared = dot(across, across);
    const Vec3d newA = toDouble(to[0]), newAb = toDouble(to[1]) - newA, newAc = toDouble(to[2]) - newA;
    const Vec3d newAcross = cross(newAb, newAc);
    if (!(squared > 0) || !(dot(newAcross, newAcross) > 0)) return std::nullopt;
    const double u = dot(cross(p, ac), across) / squared, v = dot(cross(ab, p), across) / squared;
    const double side = dot(toDouble(place.normal), across) >= 0 ? 1 : -1;
    return SurfacePlace{toFloat(newA + u * newAb + v * newAc), toFloat(side * normalized(newAcross))};
}

// Where the view has the point; nothing outside its frustum.
std::optional<Vec2f> pixelIn(const View& view, const Mat4d& clipFromLocal, Vec3d pointLocal)
{
    const Vec4d clip = clipFromLocal * point(pointLocal);
    if (!(clip.w > 0)) return std::nullopt;
    const Vec3d ndc{clip.x / clip.w, clip.y / clip.w, clip.z / clip.w};
    if (!(std::abs(ndc.x) < 1 && std::abs(ndc.y) < 1 && std::abs(ndc.z) <= 1)) return std::nullopt;
    // Rounded up, the last float before the picture's end would be that end.
    const auto within = [](double pixel, int end) { return std::min(float(pixel), std::nextafter(float(end), 0.0f)); };
    return Vec2f{within((ndc.x + 1) / 2 * view.width, view.width), within((ndc.y + 1) / 2 * view.height, view.height)};
}

} // namespace

CarriedSamples carry(const ViewSamples& before, const LocalTriangles& trianglesBefore,
                     const LocalTriangles& trianglesNow, const View& viewNow)
{
    LX_ASSERT(before.originWorld == trianglesBefore.originWorld && before.originWorld == trianglesNow.originWorld);
    const SameTriangles same(trianglesBefore, trianglesNow);
    const Mat4d clipFromLocalNow = clipFromLocal(viewNow, before.originWorld);
    CarriedSamples out;
    out.samples.width = viewNow.width, out.samples.height = viewNow.height;
    out.samples.originWorld = before.originWorld;
    for (std::size_t i = 0; i < before.size(); ++i) {
        SurfacePlace place{before.positionLocal[i], before.normal[i]};
        std::uint32_t triangle = before.triangle[i];
        if (triangle != kNoTriangle) {
            const auto now = same.at(triangle);
            const auto there =
                now ? moved(place, cornersOf(trianglesBefore, triangle), cornersOf(trianglesNow, *now)) : std::nullopt;
            if (!there) continue;
            place = *there, triangle = *now;
        }
        const Vec3d pointLocal = toDouble(place.positionLocal);
        const auto pixel = pixelIn(viewNow, clipFromLocalNow, pointLocal);
        if (!pixel || !(dot(toDouble(place.normal), towardsEye(viewNow, before.originWorld, pointLocal)) > 0)) continue;
        out.samples.pixel.push_back(*pixel);
        out.samples.positionLocal.push_back(place.positionLocal);
        out.samples.normal.push_back(place.normal);
        out.samples.triangle.push_back(triangle);
        out.from.push_back(std::uint32_t(i));
    }
    return out;
}

CarriedSamples keepOnly(const CarriedSamples& all, std::span<const float> isKept)
{
    LX_ASSERT(isKept.size() == all.from.size());
    CarriedSamples out;
    out.samples.width = all.samples.width, out.samples.height = all.samples.height;
    out.samples.originWorld = all.samples.originWorld;
    for (std::size_t i = 0; i < all.from.size(); ++i) {
        if (!(isKept[i] >= 0.5f)) continue;
        out.samples.pixel.push_back(all.samples.pixel[i]);
        out.samples.positionLocal.push_back(all.samples.positionLocal[i]);
        out.samples.normal.push_back(all.samples.normal[i]);
        out.samples.triangle.push_back(all.samples.triangle[i]);
        out.from.push_back(all.from[i]);
    }
    return out;
}

ViewSamples joined(const ViewSamples& first, const ViewSamples& second)
{
    LX_ASSERT(first.originWorld == second.originWorld && first.width == second.width && first.height == second.height);
    ViewSamples out = first;
    out.weight.clear(), out.atDepthJump.clear();
    const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
    append(out.pixel, second.pixel);
    append(out.positionLocal, second.positionLocal);
    append(out.normal, second.normal);
    append(out.triangle, second.triangle);
    return out;
}

} // namespace lixel
