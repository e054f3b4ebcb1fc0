// SPDX-License-Identifier: MIT
#include "lixel/base/enclosing_polygon.h"

#include "lixel/base/assert.h"

#include <algorithm>
#include <limits>

namespace lixel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Where the sides before and after side `i`, from corner i to the next, meet.
struct Meeting
{
    Vec2d corner;
    double area = kInfinity; // between the side and the meeting point; infinite where they do not meet ahead
};

Meeting meetingOver(std::span<const Vec2d> corners, std::size_t i)
{
    const std::size_t count = corners.size();
    const Vec2d before = corners[(i + count - 1) % count], a = corners[i], b = corners[(i + 1) % count],
                after = corners[(i + 2) % count];
    const double turn = cross(a - before, after - b);
    if (!(turn > 0)) return {};
    const double t = cross(b - a, after - b) / turn;
    const Vec2d corner = a + t * (a - before);
    const double area = cross(corner - a, b - a);
    // Corners in line but for rounding meet between themselves.
    return {corner, area < 0 ? -area : area};
}

} // namespace

std::size_t encloseWithFewerCorners(std::span<Vec2d> corners, std::size_t most)
{
    LX_ASSERT(most >= 4);
    std::size_t count = corners.size();
    while (count > most) {
        std::size_t dropped = 0;
        Meeting least;
        for (std::size_t i = 0; i < count; ++i) {
            const Meeting meeting = meetingOver(corners.first(count), i);
            if (meeting.area < least.area) least = meeting, dropped = i;
        }
        if (least.area == kInfinity) break;
        corners[dropped] = least.corner;
        const std::size_t gone = (dropped + 1) % count;
        std::copy(corners.begin() + std::ptrdiff_t(gone) + 1, corners.begin() + std::ptrdiff_t(count),
                  corners.begin() + std::ptrdiff_t(gone));
        --count;
    }
    return count;
}

} // namespace lixel
