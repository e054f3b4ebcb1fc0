// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/caster_source.h"
#include "lixel/base/light.h"
#include "lixel/base/view_samples.h"

#include <cstdint>
#include <span>
#include <vector>

// Exact visibility a second time, to check the first: the definition in lixel/trace/shadow_ray.h and
// lixel/shared/alpha.h, read as text and worked out otherwise. No code is shared: an own tree of boxes in double, the
// intersection of Moeller and Trumbore (Fast, Minimum Storage Ray/Triangle Intersection, JGT 2(1), 1997) in long
// double, an own search for the start's place on its triangle, and textures wrapped by OpenGL's table.
namespace lixel::test {

struct ReferenceAnswer
{
    bool isLit = false;
    std::uint32_t blocker = kNoTriangle; // where not lit
    bool isGrazing = false;              // the ray was turned up, because it rises less than float corners can say
    bool isLitByBareGeometry = false;    // had neither that rule nor the one of flat surfaces been applied
};

class ReferenceScene
{
public:
    // Everything stays with its owner.
    ReferenceScene(const LocalTriangles& triangles, std::span<const Material> materials,
                   std::span<const Texture> textures);

    // Of a light-facing sample with a triangle.
    ReferenceAnswer visibility(const ViewSamples& samples, std::size_t i, const Light& light) const;

    // How near the sample's ray comes to any edge in front of the light, over the distance travelled: what a
    // disagreement is explained by.
    double nearestEdge(const ViewSamples& samples, std::size_t i, const Light& light) const;

private:
    struct Node
    {
        double low[3], high[3];
        std::uint32_t first = 0, count = 0; // leaf: into order_
        std::uint32_t second = 0;           // inner: the second child; the first follows its parent
    };
    struct Ray;

    std::uint32_t build(std::uint32_t first, std::uint32_t count);
    Ray rayOf(const ViewSamples& samples, std::size_t i, const Light& light) const;
    std::uint32_t firstBlocker(const Ray& ray, bool withFlatRule) const;
    bool blocks(const Ray& ray, std::uint32_t triangle, bool withFlatRule) const;
    bool keeps(std::uint32_t triangle, long double u, long double v) const;

    const LocalTriangles& triangles_;
    std::span<const Material> materials_;
    std::span<const Texture> textures_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
    std::vector<Vec3d> centre_;
    double padding_ = 0;
};

} // namespace lixel::test
