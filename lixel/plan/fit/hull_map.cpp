// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/hull_map.h"

#include "lixel/base/fixed_vector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lixel {
namespace {

// Beyond such ratios of w what is near the axis' horizon takes the whole map.
constexpr double kLeastRelativeW = 1e-4;

// A hull that is a line or a point has this much of room around it.
constexpr double kLeastRelativeHalf = 1e-9;

// Widths that differ by less than this part do so by rounding.
constexpr double kAlike = 1e-12;

struct Extent
{
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

    void include(double v) { low = std::min(low, v), high = std::max(high, v); }
    double middle() const { return 0.5 * (low + high); }
    double half() const { return 0.5 * (high - low); }
};

} // namespace

bool HullMaps::lookAlong(Vec3d w)
{
    w_ = normalized(w);
    Extent depths;
    for (const Vec3d& r : corners_) depths.include(dot(w_, r));
    if (!(depths.low > kLeastRelativeW * depths.high)) return false;
    // The image widens along the axis' own place on the light plane; e1 is across that.
    const double aside = std::hypot(w_.x, w_.y);
    e1_ = aside > 1e-12 ? Vec3d{w_.y / aside, -w_.x / aside, 0} : Vec3d{1, 0, 0};
    e2_ = cross(w_, e1_);
    room_.clear();
    for (const Vec3d& r : corners_) room_.push_back((1 / dot(w_, r)) * Vec2d{dot(e1_, r), dot(e2_, r)});
    image_ = room_;
    return true;
}

HullMaps::Sides HullMaps::sides(std::size_t number) const
{
    Sides out;
    out.along = {1, 0};
    if (number < image_.size()) {
        const Vec2d side = image_[number + 1 < image_.size() ? number + 1 : 0] - image_[number];
        const double size = length(side);
        if (size > 0) out.along = (1 / size) * side;
    }
    const Vec2d across{-out.along.y, out.along.x};
    Extent x, y;
    for (const Vec2d& p : image_) x.include(dot(out.along, p)), y.include(dot(across, p));
    out.centre = {x.middle(), y.middle()};
    const double least = kLeastRelativeHalf * (std::abs(x.middle()) + std::abs(y.middle()) + x.half() + y.half());
    out.half = {std::max(x.half(), least), std::max(y.half(), least)};
    return out;
}

HullMaps::Sides HullMaps::sheared(const Sides& upright) const
{
    const Vec2d across{-upright.along.y, upright.along.x};
    const auto extentOf = [&](double shear) {
        const Vec2d leaning = upright.along + shear * across;
        Extent extent;
        for (const Vec2d& p : image_) extent.include(dot(leaning, p));
        return extent;
    };
    // The width is convex and piecewise linear in the shear; it bends where a side of the hull stands upright. Where the rectangle's
    // side is as wide as all, shears between two bends are alike: of these the least, which is Figure 3's, changes lixels least. So
    // it is sought from none outwards, either way.
    Sides out = upright;
    Extent best = extentOf(0);
    for (const double way : {-1.0, 1.0}) {
        FixedVector<double, kMostCorners> bends;
        for (std::size_t i = 0; i < image_.size(); ++i) {
            const Vec2d side = image_[i + 1 < image_.size() ? i + 1 : 0] - image_[i];
            const double up = dot(across, side), bend = -way * dot(upright.along, side) / up;
            if (std::abs(up) > 1e-9 * length(side) && bend > 0) bends.push_back(bend);
        }
        std::sort(bends.begin(), bends.end());
        // The first bend that is not wider than the next.
        const double* least = std::partition_point(bends.begin(), bends.end(), [&](const double& bend) {
            const double* next = &bend + 1;
            return next != bends.end() && extentOf(way * *next).half() < (1 - kAlike) * extentOf(way * bend).half();
        });
        if (least == bends.end()) continue;
        const Extent extent = extentOf(way * *least);
        if (extent.half() < (1 - kAlike) * best.half()) best = extent, out.shear = way * *least;
    }
    out.centre.x = best.middle();
    out.half.x = best.half();
    return out;
}

HullMaps::Steps HullMaps::steps(const Sides& sides, bool isTurned) const
{
    const double width = std::sqrt(aspect_), height = 1 / width;
    const Vec2d across{-sides.along.y, sides.along.x};
    const Vec2d up = across - sides.shear * sides.along; // at a constant place along
    const auto step = [&](Vec2d image, double half, double lixels) {
        return (2 * half / lixels) * (image.x * e1_ + image.y * e2_);
    };
    if (isTurned) return {step(up, sides.half.y, width), -step(sides.along, sides.half.x, height)};
    return {step(sides.along, sides.half.x, width), step(up, sides.half.y, height)};
}

PlaneWarp HullMaps::rows(const Sides& sides, bool isTurned) const
{
    const double width = std::sqrt(aspect_), height = 1 / width;
    const Vec2d a = sides.along, across{-a.y, a.x};
    const auto row = [&](Vec2d image, double centre, double half, double lixels) {
        return (0.5 * lixels / half) * (image.x * e1_ + image.y * e2_ - centre * w_);
    };
    const Vec2d leaning = a + sides.shear * across;
    if (isTurned)
        return {row(across, sides.centre.y, sides.half.y, width), -row(leaning, sides.centre.x, sides.half.x, height),
                w_};
    return {row(leaning, sides.centre.x, sides.half.x, width), row(across, sides.centre.y, sides.half.y, height), w_};
}

} // namespace lixel
