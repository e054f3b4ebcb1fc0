// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/mat4.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

// The paper's own way to its light matrix (H. Chong, S. Gortler. A Lixel for every Pixel. 2004, equations 1 and 7-10): the projective
// matrix that takes five points of space to five given images, by two linear systems (O. Faugeras. Three-dimensional Computer Vision.
// 1993).
namespace lixel::test {

using Column = std::array<long double, 4>;
using Columns = std::array<Column, 4>; // of a matrix

inline Column asColumn(Vec4d a) { return {a.x, a.y, a.z, a.w}; }

// x with m x = b, by elimination with pivots; nothing where the columns are so nearly dependent that the digits of b do not do.
inline std::optional<Column> solve(Columns m, Column b)
{
    constexpr long double kLeastPivot = 1e-4L;
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivot = k;
        for (std::size_t r = k; r < 4; ++r)
            if (std::abs(m[k][r]) > std::abs(m[k][pivot])) pivot = r;
        if (!(std::abs(m[k][pivot]) > kLeastPivot)) return std::nullopt;
        for (std::size_t c = 0; c < 4; ++c) std::swap(m[c][k], m[c][pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t r = k + 1; r < 4; ++r) {
            const long double f = m[k][r] / m[k][k];
            for (std::size_t c = k; c < 4; ++c) m[c][r] -= f * m[c][k];
            b[r] -= f * b[k];
        }
    }
    Column x{};
    for (std::size_t k = 4; k-- > 0;) {
        x[k] = b[k];
        for (std::size_t c = k + 1; c < 4; ++c) x[k] -= m[c][k] * x[c];
        x[k] /= m[k][k];
    }
    return x;
}

// The matrix that takes the four unit vectors to the first four points and (1, 1, 1, 1) to the fifth, all but for factors.
inline std::optional<Columns> fromBasis(const std::array<Column, 5>& points)
{
    Columns m{points[0], points[1], points[2], points[3]};
    const auto factors = solve(m, points[4]);
    if (!factors) return std::nullopt;
    for (std::size_t c = 0; c < 4; ++c)
        for (long double& v : m[c]) v *= (*factors)[c];
    return m;
}

// `corners`: where the rays of sight through (0, 0), (0, h), (w, h), (w, 0) meet the plane, homogeneous; `raised`: how far the fourth is
// moved towards the light (p-hat), of the whole way; `size`: of the scene, which it is solved in units of. Nothing where the points do
// not determine it.
inline std::optional<Mat4d> fivePointMatrix(const std::array<Vec4d, 4>& corners, double w, double h, Vec4d light,
                                            double size, double raised)
{
    const auto unit = [size](Vec4d a) {
        a.w *= size;
        return (1 / std::sqrt(dot(a, a))) * a;
    };
    const Vec4d raisedCorner = (1 - raised) * unit(corners[3]) + raised * unit(light);
    const std::array<Column, 5> points{asColumn(unit(corners[0])), asColumn(unit(corners[1])),
                                       asColumn(unit(corners[2])), asColumn(raisedCorner), asColumn(unit(light))};
    const std::array<Column, 5> images{asColumn({0, 0, 1, 1}), asColumn({0, h, 1, 1}), asColumn({w, h, 1, 1}),
                                       asColumn({w, 0, -1, 1}), asColumn({0, 0, 1, 0})};
    const auto a = fromBasis(points), b = fromBasis(images);
    if (!a || !b) return std::nullopt;
    Mat4d out;
    for (std::size_t c = 0; c < 4; ++c) { // m = b a^-1, a column at a time
        Column e{};
        e[c] = 1;
        const auto x = solve(*a, e);
        if (!x) return std::nullopt;
        for (std::size_t r = 0; r < 4; ++r) {
            long double sum = 0;
            for (std::size_t k = 0; k < 4; ++k) sum += (*b)[k][r] * (*x)[k];
            out.m[r][c] = double(sum) * (c == 3 ? size : 1);
        }
    }
    return out;
}

} // namespace lixel::test
