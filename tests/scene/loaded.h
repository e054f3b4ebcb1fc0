// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/evaluate.h"
#include "lixel/scene/load.h"
#include "support/scene_files.h"

#include <memory>
#include <string>
#include <vector>

namespace lixel::test {

inline std::shared_ptr<const Scene> loadData(const std::string& file)
{
    return std::make_shared<const Scene>(loadScene((dataFolder() / file).string()));
}

inline SceneBuffers evaluateData(const std::string& file, EvaluateOptions options = {})
{
    return evaluate(loadData(file), options, {});
}

// Corners of all triangles, in order.
inline std::vector<Vec3f> corners(const SceneBuffers& buffers)
{
    std::vector<Vec3f> all;
    for (const std::uint32_t i : buffers.triangles.indices) all.push_back(buffers.triangles.positionLocal[i]);
    return all;
}

inline void expectNear(const std::vector<Vec3f>& found, const std::vector<Vec3f>& expected, double within)
{
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_LE(length(toDouble(found[i]) - toDouble(expected[i])), within)
            << "corner " << i << ": " << found[i].x << " " << found[i].y << " " << found[i].z;
}

inline void expectNear(Vec3d found, Vec3d expected, double within)
{
    EXPECT_LE(length(found - expected), within) << found.x << " " << found.y << " " << found.z;
}

} // namespace lixel::test
