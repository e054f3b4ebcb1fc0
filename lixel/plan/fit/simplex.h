// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lixel {

// A place on a plane, and what a function is there.
struct PlaneValue
{
    Vec2d p;
    double energy = std::numeric_limits<double>::infinity();
};

// Downhill on a plane without derivatives, from a start and two places `size` beside it; infinite is uphill.
//
//   J. A. Nelder, R. Mead. A Simplex Method for Function Minimization. The Computer Journal 7, 1965.
template <typename Energy>
PlaneValue leastBySimplex(const PlaneValue& start, double size, int steps, const Energy& energy)
{
    const auto at = [&](Vec2d p) { return PlaneValue{p, energy(p)}; };
    const auto isLess = [](const PlaneValue& a, const PlaneValue& b) { return a.energy < b.energy; };
    std::array<PlaneValue, 3> s{start, at(start.p + Vec2d{size, 0}), at(start.p + Vec2d{0, size})};
    for (int i = 0; i < steps; ++i) {
        std::sort(s.begin(), s.end(), isLess);
        const Vec2d middle = 0.5 * (s[0].p + s[1].p), away = middle - s[2].p;
        const PlaneValue mirrored = at(middle + away);
        if (mirrored.energy < s[0].energy) {
            const PlaneValue farther = at(middle + 2 * away);
            s[2] = farther.energy < mirrored.energy ? farther : mirrored;
        } else if (mirrored.energy < s[1].energy) {
            s[2] = mirrored;
        } else {
            const PlaneValue nearer = at(middle + (mirrored.energy < s[2].energy ? 0.5 : -0.5) * away);
            if (nearer.energy < std::min(mirrored.energy, s[2].energy)) {
                s[2] = nearer;
            } else {
                for (std::size_t k = 1; k < 3; ++k) s[k] = at(0.5 * (s[0].p + s[k].p));
            }
        }
    }
    return *std::min_element(s.begin(), s.end(), isLess);
}

} // namespace lixel
