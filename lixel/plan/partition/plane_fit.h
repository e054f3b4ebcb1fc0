// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/plane.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

// Whether samples lie on a plane, and on which.
namespace lixel {

struct PlaneSample
{
    Vec3d p, normal;
    double weight = 0;
    double tolerance = 0; // how far from a plane it may be and count as lying on it, > 0
};

// Fits need so many samples.
inline constexpr std::size_t kLeastPlaneSamples = 16;

// Cosines of 5 degrees, the noise of normals that were taken from depths, and of 10 degrees: samples with normals so far from
// a plane's can tell whether it goes on as a curve.
inline constexpr double kSameNormal = 0.99619;
inline constexpr double kSimilarNormal = 0.98481;

inline bool isOnPlane(const PlaneSample& sample, const Plane& plane, double tolerances = 1)
{
    return std::abs(plane.signedDistance(sample.p)) <= tolerances * sample.tolerance &&
           dot(sample.normal, plane.normal) >= kSameNormal;
}

// A plane and the samples of a group that lie on it.
struct JudgedPlane
{
    Plane plane;
    double weight = 0;
    double miss = 0; // their distances from it in tolerances, root mean square
    std::size_t count = 0;
    std::size_t sharp = 0;    // of those, within an eighth of the tolerance
    std::size_t beside = 0;   // samples within eight tolerances that do not lie on it
    std::size_t parallel = 0; // of those, with the plane's very normal, to half a degree

    // Most samples lie on it to rounding: it ends where they do.
    bool isSharp() const { return 4 * sharp > 3 * count; }

    // A slice of something curved or rough ends where the tolerance does, not where the surface does: distances fill the tolerance
    // (evenly they have a root mean square of 0.58), or a third as many samples lie beside it as on it (beside a slice of a
    // cylinder 1.1 times as many, of a sphere 3.5 times). A sharp plane may have others beside it that are parallel, as
    // kerbs from far away.
    bool isSlice() const
    {
        const bool fillsTolerance = !isSharp() && miss > 0.35;
        return fillsTolerance || 3 * (isSharp() ? beside - parallel : beside) > count;
    }
};

JudgedPlane judgePlane(std::span<const PlaneSample> group, const Plane& plane);

// The plane that samples around a proposal lie on: weighted least squares, again and again over those that lie on the last fit,
// exact where they are. Samples that agree with the proposal to rounding are fitted apart from others within the
// tolerance. `group` has the samples whose normals are similar to the plane's. Nothing where the samples are too few, or lie
// in a line.
std::optional<JudgedPlane> settlePlane(std::span<const PlaneSample> group, const Plane& proposal);

} // namespace lixel
