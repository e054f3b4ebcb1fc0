// SPDX-License-Identifier: MIT
#include "lixel/base/mat4.h"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace lixel {

bool isFinite(const Mat4d& a)
{
    for (const auto& row : a.m)
        for (const double value : row)
            if (!std::isfinite(value)) return false;
    return true;
}

std::optional<Mat4d> inverse(const Mat4d& a)
{
    // Rows are brought to unit size first, so that the determinant says how singular the matrix is, not how small.
    double rowSize[4];
    glm::dmat4 g; // g[column][row]
    for (int i = 0; i < 4; ++i) {
        rowSize[i] = std::sqrt(dot(a.row(i), a.row(i)));
        if (!(rowSize[i] > 0) || !std::isfinite(rowSize[i])) return std::nullopt;
        for (int j = 0; j < 4; ++j) g[j][i] = a.m[i][j] / rowSize[i];
    }
    if (!(std::abs(glm::determinant(g)) > 1e-300)) return std::nullopt;
    const glm::dmat4 gInverse = glm::inverse(g);
    Mat4d b;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) b.m[i][j] = gInverse[j][i] / rowSize[j];
    if (!isFinite(b)) return std::nullopt;
    return b;
}

} // namespace lixel
