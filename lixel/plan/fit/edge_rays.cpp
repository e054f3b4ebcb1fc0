// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/edge_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lixel {
namespace {

// Sines of angles between surface and line of sight or light ray below this are rounding.
constexpr double kLeastSine = 1e-7;

// Unit normals of the edges that stand for those in all directions of a surface.
constexpr double kDiagonal = 0.5 * std::numbers::sqrt2;
constexpr std::array<Vec2d, 4> kDirections{{{1, 0}, {kDiagonal, kDiagonal}, {0, 1}, {-kDiagonal, kDiagonal}}};

// The golden section: its multiples, less whole numbers, are spread evenly.
constexpr double kGolden = std::numbers::phi - 1;

Vec3d at(const EdgeRays::Vectors& v, std::size_t i) { return {v[0][i], v[1][i], v[2][i]}; }

void append(EdgeRays::Vectors& v, Vec3d value)
{
    v[0].push_back(value.x), v[1].push_back(value.y), v[2].push_back(value.z);
}

void scale(std::vector<double>& weights)
{
    double sum = 0;
    for (const double w : weights) sum += w;
    if (sum > 0)
        for (double& w : weights) w /= sum;
}

// How the surface at a sample lies in the picture: pixels a unit along two tangents.
struct OnPicture
{
    Vec3d t1, t2;
    Vec2d p1, p2;

    OnPicture(const Mat4d& pixelsFromLocal, const NeedSample& sample)
        : t1(anyPerpendicular(sample.normal)), t2(cross(sample.normal, t1))
    {
        const Vec4d at = pixelsFromLocal * point(sample.pointLocal);
        const double perW = 1 / at.w, x = perW * at.x, y = perW * at.y;
        const auto along = [&](Vec3d tangent) {
            const Vec4d change = pixelsFromLocal * direction(tangent);
            return perW * Vec2d{change.x - change.w * x, change.y - change.w * y};
        };
        p1 = along(t1), p2 = along(t2);
    }
};

} // namespace

void EdgeRays::clear()
{
    for (Vectors* v : {&ray, &first, &second, &edgeRay, &across})
        for (auto& component : *v) component.clear();
    weight.clear(), edgeWeight.clear();
}

void EdgeRays::add(Vec3d r, Vec3d k1, Vec3d k2, double sampleWeight)
{
    append(ray, r), append(first, k1), append(second, k2);
    weight.push_back(sampleWeight);
}

void EdgeRays::addEdge(Vec3d r, Vec3d k, double sampleWeight)
{
    append(edgeRay, r), append(across, k);
    edgeWeight.push_back(sampleWeight);
}

void EdgeRays::normaliseWeights() { scale(weight), scale(edgeWeight); }

void EdgeRays::assign(const View& view, Vec3d originWorld, const Mat4d& framed, std::span<const NeedSample> samples)
{
    clear();
    Mat4d pixels = clipFromLocal(view, originWorld);
    pixels.setRow(0, 0.5 * view.width * pixels.row(0));
    pixels.setRow(1, 0.5 * view.height * pixels.row(1));
    const auto rayOf = [&](Vec4d p) {
        return Vec3d{dot(framed.row(0), p), dot(framed.row(1), p), dot(framed.row(3), p)};
    };
    for (const NeedSample& sample : samples) {
        const OnPicture picture(pixels, sample);
        const double area = cross(picture.p1, picture.p2);
        const double longest = std::max(dot(picture.p1, picture.p1), dot(picture.p2, picture.p2));
        if (!(std::abs(area) > kLeastSine * longest)) continue;
        const Vec3d r = rayOf(point(sample.pointLocal)), s1 = rayOf(direction(picture.t1)),
                    s2 = rayOf(direction(picture.t2));
        // A pixel to the right, and one up, along the surface.
        const double perArea = 1 / area;
        const Vec3d r1 = perArea * (picture.p2.y * s1 - picture.p1.y * s2),
                    r2 = perArea * (picture.p1.x * s2 - picture.p2.x * s1);
        const double volume = dot(r, cross(r1, r2));
        if (!(r.z > 0) || !(std::abs(volume) > kLeastSine * length(r) * length(r1) * length(r2)) ||
            !std::isfinite(volume))
            continue;
        const double perVolume = 1 / volume;
        const Vec3d k1 = perVolume * cross(r2, r), k2 = -perVolume * cross(r1, r);
        add(r, k1, k2, sample.weight);
        if (dot(sample.across, sample.across) > 0) {
            addEdge(r, sample.across.x * k1 + sample.across.y * k2, sample.weight);
            continue;
        }
        // An edge with the unit normal m on the surface moves by |area| / size pixels across itself for each unit along m (need.h).
        const double size = std::sqrt(0.5 * (dot(picture.p1, picture.p1) + dot(picture.p2, picture.p2)));
        for (const Vec2d& m : kDirections) {
            // m as a function of pixels: the inverse of [p1 p2], transposed.
            const Vec2d n =
                (1 / size) * Vec2d{m.x * picture.p2.y - m.y * picture.p1.y, m.y * picture.p1.x - m.x * picture.p2.x};
            addEdge(r, n.x * k1 + n.y * k2, sample.weight / kDirections.size());
        }
    }
    normaliseWeights();
}

void EdgeRays::assignSome(const EdgeRays& all, std::size_t count)
{
    clear();
    // What weighs more than its turn counts as often as it is taken. Turns come irregularly, since samples do not: they go along rows
    // of the picture, and around directions.
    const auto some = [count](std::span<const double> weights, auto&& take) {
        if (weights.size() <= count) {
            for (std::size_t i = 0; i < weights.size(); ++i) take(i, weights[i]);
            return;
        }
        double sum = 0, turn = kGolden;
        std::size_t turns = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            sum += double(count) * weights[i];
            std::size_t times = 0;
            for (; turns < count && double(turns) + turn < sum; ++turns, ++times) {
                turn += kGolden;
                turn -= std::floor(turn);
            }
            if (times > 0) take(i, double(times));
        }
    };
    some(all.weight, [&](std::size_t i, double w) { add(at(all.ray, i), at(all.first, i), at(all.second, i), w); });
    some(all.edgeWeight, [&](std::size_t i, double w) { addEdge(at(all.edgeRay, i), at(all.across, i), w); });
    normaliseWeights();
}

} // namespace lixel
