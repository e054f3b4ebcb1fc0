// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/lixel_energy.h"
#include "plan/edge_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>

// The derivatives of light images as Chong & Gortler 2007 write them out, twins of EdgeRays.
namespace lixel::test {

// d pixel / d lixel of one sample: [pixel x or y][u of row x or y].
using Inverse = std::array<std::array<double, 2>, 2>;

inline Inverse inverseOf(const std::array<std::array<double, 2>, 2>& m)
{
    const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return {{{m[1][1] / determinant, -m[0][1] / determinant}, {-m[1][0] / determinant, m[0][0] / determinant}}};
}

// As EdgeRays have it.
inline Inverse inverseBy(const EdgeRays& rays, std::size_t i, const PlaneWarp& map)
{
    const DualBasis dual = dualBasis(map);
    const auto at = [i](const EdgeRays::Vectors& v) { return Vec3d{v[0][i], v[1][i], v[2][i]}; };
    const double w = dot(map.w, at(rays.ray));
    const Vec3d k1 = at(rays.first), k2 = at(rays.second);
    return {{{w * dot(k1, dual.b1), w * dot(k1, dual.b2)}, {w * dot(k2, dual.b1), w * dot(k2, dual.b2)}}};
}

inline double farthest(const Inverse& a, const Inverse& b)
{
    double apart = 0, size = 0;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            apart = std::max(apart, std::abs(a[std::size_t(i)][std::size_t(j)] - b[std::size_t(i)][std::size_t(j)]));
            size = std::max(size, std::abs(b[std::size_t(i)][std::size_t(j)]));
        }
    return apart / size;
}

// The view in pixels, from a frame of the light that has its point at the origin (light space), or from Local.
inline Mat4d pixelsFrom(const EdgeScene& s)
{
    Mat4d pixels = clipFromLocal(s.view, s.originWorld);
    pixels.setRow(0, 0.5 * s.view.width * (pixels.row(0) + pixels.row(3)));
    pixels.setRow(1, 0.5 * s.view.height * (pixels.row(1) + pixels.row(3)));
    return pixels;
}

// Chong & Gortler 2007, section 2.1 and appendix A, in its own letters.
class Appendix
{
public:
    // P's rows 1, 2 and 4 without their zeros.
    Appendix(const EdgeScene& s, const NeedSample& sample, const PlaneWarp& map) : p_{map.x, map.y}, p4_(map.w)
    {
        const LightFrame& frame = s.frame;
        Mat4d lightFromLocal = frame.framedFromLocal;
        lightFromLocal.setRow(3, {0, 0, 0, 1});
        const Mat4d Q = pixelsFrom(s) * inverse(lightFromLocal).value(), back = inverse(Q).value();
        X_ = transformPoint(lightFromLocal, sample.pointLocal);
        wq_ = (Q * point(X_)).w;
        for (std::size_t j = 0; j < 4; ++j) q_[j] = {back.m[0][j], back.m[1][j], back.m[2][j]};
        // The surface on the screen, a plane again: x3 as a function of x1 and x2.
        const Vec3d n = transformDirection(lightFromLocal, sample.normal);
        const std::array<double, 4> plane{n.x, n.y, n.z, -dot(n, X_)};
        std::array<double, 4> onScreen{};
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k) onScreen[j] += plane[k] * back.m[k][j];
        dx3_ = {-onScreen[0] / onScreen[2], -onScreen[1] / onScreen[2]};
    }

    // Equation 8, i = 1, 2, j = 1, 2, 3.
    double partial(std::size_t i, std::size_t j) const
    {
        const double p4X = dot(p4_, X_);
        return wq_ / p4X * (dot(p_[i], q_[j]) - dot(p_[i], X_) / p4X * dot(p4_, q_[j]));
    }

    // The appendix' last equation.
    Vec3d gradientOfPartial(std::size_t i, std::size_t j) const
    {
        const double p4X = dot(p4_, X_), piX = dot(p_[i], X_);
        return wq_ / (p4X * p4X) * ((2 * piX * dot(p4_, q_[j]) / p4X - dot(p_[i], q_[j])) * X_ - piX * q_[j]);
    }

    // Equation 7.
    double total(std::size_t i, std::size_t j) const { return partial(i, j) + partial(i, 2) * dx3_[j]; }
    Vec3d gradientOfTotal(std::size_t i, std::size_t j) const
    {
        return gradientOfPartial(i, j) + dx3_[j] * gradientOfPartial(i, 2);
    }

    Inverse inverseJacobian() const { return inverseOf({{{total(0, 0), total(0, 1)}, {total(1, 0), total(1, 1)}}}); }

    // A sample's addend to equation 9.
    double badness() const
    {
        double squares = 0;
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j < 2; ++j) squares += total(i, j) * total(i, j);
        const double detJ = total(0, 0) * total(1, 1) - total(0, 1) * total(1, 0);
        return squares / (detJ * detJ);
    }
    // By the product rule.
    Vec3d gradientOfBadness() const
    {
        const double detJ = total(0, 0) * total(1, 1) - total(0, 1) * total(1, 0);
        Vec3d ofSquares;
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j < 2; ++j) ofSquares = ofSquares + 2 * total(i, j) * gradientOfTotal(i, j);
        const Vec3d ofDet = total(1, 1) * gradientOfTotal(0, 0) + total(0, 0) * gradientOfTotal(1, 1) -
                            total(1, 0) * gradientOfTotal(0, 1) - total(0, 1) * gradientOfTotal(1, 0);
        return ofSquares / (detJ * detJ) - (2 * badness() / detJ) * ofDet;
    }

private:
    std::array<Vec3d, 2> p_;
    Vec3d p4_, X_;
    double wq_ = 0;
    std::array<Vec3d, 4> q_;
    std::array<double, 2> dx3_{};
};

} // namespace lixel::test
