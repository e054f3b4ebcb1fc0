// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/evaluate.h"

#include <vector>

// Where every node is at a moment, in double.
namespace lixel {

struct Pose
{
    std::vector<Mat4d> worldFromNode;              // one a node
    std::vector<std::vector<double>> morphWeights; // one a node; empty: the mesh's own
};

// No animation: the transforms as they stand.
Pose restPose(const Scene& scene);

// The chosen animation at its time, repeating. Scene::animate is not called here.
Pose poseAt(const Scene& scene, const EvaluateOptions& options);

// Nodes below the roots, in the order of the file: parents before children, children in turn. Needs a forest.
std::vector<int> drawnNodes(const Scene& scene);

} // namespace lixel
