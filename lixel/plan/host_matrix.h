// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/mat4.h"

#include <array>
#include <cstddef>
#include <span>

// 16 numbers as a host's maths library keeps them in memory. Columns one after the other: GLSL, GLM, Metal's simd, Eigen, and
// also libraries that write vectors as rows and store row after row (DirectXMath, System.Numerics), whose memory is the same.
// Rows of a matrix that acts on columns (HLSL's row_major with mul(M, v)): transpose() first.
namespace lixel {

template <typename T>
Mat4d matrixFromColumns(std::span<const T, 16> columns)
{
    Mat4d out;
    for (std::size_t i = 0; i < 16; ++i) out.m[i % 4][i / 4] = double(columns[i]);
    return out;
}
inline Mat4d matrixFromColumns(const float (&columns)[16])
{
    return matrixFromColumns(std::span<const float, 16>(columns));
}
inline Mat4d matrixFromColumns(const double (&columns)[16])
{
    return matrixFromColumns(std::span<const double, 16>(columns));
}

// The same as floats, ready to be copied into a uniform or a constant buffer.
inline std::array<float, 16> columnsOf(const Mat4d& matrix)
{
    std::array<float, 16> out{};
    for (std::size_t i = 0; i < 16; ++i) out[i] = float(matrix.m[i % 4][i / 4]);
    return out;
}

} // namespace lixel
