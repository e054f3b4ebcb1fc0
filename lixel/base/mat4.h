// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/vec.h"

#include <optional>

// A 4x4 matrix applied to columns, named destination-from-source: clipFromWorld * pointWorld is in clip space.
namespace lixel {

struct Mat4d
{
    double m[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}; // m[row][column]; identity by default

    constexpr Vec4d row(int i) const { return {m[i][0], m[i][1], m[i][2], m[i][3]}; }
    constexpr void setRow(int i, Vec4d r) { m[i][0] = r.x, m[i][1] = r.y, m[i][2] = r.z, m[i][3] = r.w; }
    static constexpr Mat4d fromRows(Vec4d r0, Vec4d r1, Vec4d r2, Vec4d r3)
    {
        Mat4d a;
        a.setRow(0, r0), a.setRow(1, r1), a.setRow(2, r2), a.setRow(3, r3);
        return a;
    }
    friend constexpr bool operator==(const Mat4d&, const Mat4d&) = default;
};

constexpr Mat4d operator*(const Mat4d& a, const Mat4d& b)
{
    Mat4d c;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            c.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j] + a.m[i][3] * b.m[3][j];
    return c;
}

constexpr Vec4d operator*(const Mat4d& a, Vec4d v)
{
    return {dot(a.row(0), v), dot(a.row(1), v), dot(a.row(2), v), dot(a.row(3), v)};
}

constexpr Vec4d point(Vec3d p) { return {p.x, p.y, p.z, 1}; }
constexpr Vec4d direction(Vec3d d) { return {d.x, d.y, d.z, 0}; }

// The point of `p` under the matrix, after division by w. Needs w != 0.
constexpr Vec3d project(const Mat4d& a, Vec3d p)
{
    const Vec4d q = a * point(p);
    return xyz(q) / q.w;
}
constexpr Vec3d transformPoint(const Mat4d& a, Vec3d p) { return xyz(a * point(p)); }
constexpr Vec3d transformDirection(const Mat4d& a, Vec3d d) { return xyz(a * direction(d)); }

constexpr Mat4d transpose(const Mat4d& a)
{
    Mat4d t;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) t.m[i][j] = a.m[j][i];
    return t;
}

constexpr Mat4d translation(Vec3d t)
{
    return Mat4d::fromRows({1, 0, 0, t.x}, {0, 1, 0, t.y}, {0, 0, 1, t.z}, {0, 0, 0, 1});
}
constexpr Mat4d scaling(Vec3d s)
{
    return Mat4d::fromRows({s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}, {0, 0, 0, 1});
}

// Nothing where the matrix is singular or not finite.
std::optional<Mat4d> inverse(const Mat4d& a);

bool isFinite(const Mat4d& a);

} // namespace lixel
