// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/plan/fit/need_sample.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lixel {

// Receivers near the edges of shadows, as the picture and a light's plane see them: all that energies of light images ask
// (lixel_energy.h).
//
// A sample's ray r = (x, y, w) is its place on the light plane (LightFrame), and it moves by r1 and r2 a pixel along its surface. With
// D = det(r, r1, r2) and the vectors
//
//     k1 = (r2 x r) / D,   k2 = -(r1 x r) / D
//
// a light image with rows x, y, w (PlaneWarp) in which u = (x.r / w.r, y.r / w.r) has the derivatives
//
//     d pixel i / d u j = (w.r) (ki . bj)
//
// where b1, b2, a is the basis dual to the rows (b1.x = 1, b1.y = b1.w = 0, and so on). So the inverse Jacobian, which Chong & Gortler
// 2007 find by inverting equations 7 and 8, is bilinear in w and in what the rows' basis is, and nothing is inverted.
//
// Structures of arrays: x, y and z of each vector apart.
class EdgeRays
{
public:
    using Vectors = std::array<std::vector<double>, 3>;

    // Weights come out with a sum of 1. Samples whose surface is edge-on to the view or to the light, but for rounding, are left out.
    void assign(const View& view, Vec3d originWorld, const Mat4d& framedFromLocal, std::span<const NeedSample> samples);

    // Of the samples of others about so many, as often as they weigh, spread over all.
    void assignSome(const EdgeRays& all, std::size_t count);

    std::size_t size() const { return weight.size(); }
    bool isEmpty() const { return weight.empty(); }

    Vectors ray, first, second; // r, k1, k2
    std::vector<double> weight;

    // Across the shadow's edge: with n at right angles to it in the picture, across = n.x k1 + n.y k2, and a step of u j is
    // (w.r) |across . bj| wide there, in pixels. Where the edge's direction is unknown there are several, as if it ran along the
    // surface in any direction alike.
    Vectors edgeRay, across;
    std::vector<double> edgeWeight;

private:
    void add(Vec3d r, Vec3d k1, Vec3d k2, double sampleWeight);
    void addEdge(Vec3d r, Vec3d k, double sampleWeight);
    void clear();
    void normaliseWeights();
};

} // namespace lixel
