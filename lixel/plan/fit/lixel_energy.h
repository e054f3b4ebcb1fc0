// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/edge_rays.h"
#include "lixel/plan/fit/light_frame.h"

#include <array>
#include <cstdint>
#include <string_view>

// How bad a light image is for a picture: energies of planar maps of the light plane, from inverse Jacobians alone.
//
//   H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, equations 5, 6 and 9, appendix A.
//   D. B. Lloyd. Logarithmic Perspective Shadow Maps. PhD thesis, 2007 (m, the largest singular value).
//
//   Differs  means over the samples, where the paper has sums; a light plane in place of light space, so that lights at a point and
//            parallel light are one case; derivatives by EdgeRays in place of the appendix's, which the tests keep as a twin
namespace lixel {

enum class LixelMetric : std::uint8_t {
    L2,    // the paper's: the sum of the squares of all four derivatives d pixel i / d lixel j; pixels squared
    Lloyd, // the longest axis of a lixel in the picture; pixels
    Area,  // of a lixel in the picture; pixels squared
    Width  // a lixel's width across the edge of the shadow, the sum of both its sides'; pixels
};
std::string_view nameOf(LixelMetric metric);

// A light image's rows on rays (x, y, w): u = (x.r / w.r, y.r / w.r), counted in lixels. Infinite where w.r is not above 0 for some
// sample. The mean over all samples.
double lixelEnergy(LixelMetric metric, const EdgeRays& rays, const PlaneWarp& map);

// And how it changes with the row w, the optical axis, rows x and y held ("d h / d p4").
struct EnergyChange
{
    double energy = 0;
    Vec3d withW;
};
EnergyChange lixelEnergyChange(LixelMetric metric, const EdgeRays& rays, const PlaneWarp& map);

// L2's addends, one a sample: the paper's badness.
void badnesses(const EdgeRays& rays, const PlaneWarp& map, std::vector<double>& out);

// The vectors b1, b2, a of EdgeRays.
struct DualBasis
{
    Vec3d b1, b2, a;
};
DualBasis dualBasis(const PlaneWarp& map);

// The energy L2 of every light image at once. It is a form of second degree in w and of second degree in b1 and b2, whose 36
// coefficients are one sum over the samples:
//
//     L2 = sum over j of bj. Q(w) bj,   Q(w) = sum over samples of weight (w.r)^2 (k1 k1' + k2 k2')
//
// With each sample's weight divided by what it measures now, it stands for Lloyd's m or the width of images nearby.
class SquaresForm
{
public:
    static SquaresForm ofL2(const EdgeRays& rays);
    static SquaresForm near(LixelMetric metric, const EdgeRays& rays, const PlaneWarp& map, std::vector<double>& room);

    // xx, xy, xz, yy, yz, zz of Q(w).
    std::array<double, 6> at(Vec3d w) const;

private:
    void add(const EdgeRays::Vectors& ray, const EdgeRays::Vectors& k, std::span<const double> weight);

    std::array<std::array<double, 6>, 6> sums_{}; // [products of r][products of k]
};

// The same for the area: a form of third degree in w.
//
//     Area = sum over samples of weight (w.r)^3 / |D|, times |det(b1, b2, w)| / w.w = 1 / |det(x, y, w)|
class CubesForm
{
public:
    explicit CubesForm(const EdgeRays& rays);
    double at(Vec3d w) const;

private:
    std::array<double, 10> sums_{};
};

} // namespace lixel
