// SPDX-License-Identifier: MIT
#include "lixel/plan/place.h"

#include <algorithm>

namespace lixel {

Mat4d place(const Fit& fit, const LixelRectangle& rectangle, const LookupLayout& lookup)
{
    Mat4d clip = fit.lightClipFromLocal;
    // Row x is 1 / half size along x (points: of the light plane), so the larger side has the smaller row.
    const double sizeX = 1 / length(xyz(clip.row(0))), sizeY = 1 / length(xyz(clip.row(1)));
    if ((rectangle.width() > rectangle.height() && sizeX < sizeY) ||
        (rectangle.width() < rectangle.height() && sizeX > sizeY)) {
        const Vec4d x = clip.row(0);
        clip.setRow(0, clip.row(1));
        clip.setRow(1, -1.0 * x); // a turn, not a mirror
    }
    const auto shrink = [&lookup](int lixels) { return std::max(1 - 2 * lookup.reach / lixels, 1.0 / lixels); };
    clip.setRow(0, shrink(rectangle.width()) * clip.row(0));
    clip.setRow(1, shrink(rectangle.height()) * clip.row(1));
    return clip;
}

} // namespace lixel
