// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view_samples.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

// Embree, and all that lixel knows of it: two search trees over one list of triangles.
namespace lixel {

// A ray as floats can say it. Local space; t counts in lengths of `direction`.
struct SearchRay
{
    Vec3f origin, direction;
    float tMin = 0, tMax = 0; // tMax < tMin: no ray
};

struct SearchHit
{
    std::uint32_t triangle = kNoTriangle;
    float t = 0;
    float u = 0, v = 0; // weights of the triangle's second and third corner
};

class EmbreeScene
{
public:
    EmbreeScene(std::span<const Vec3f> positionLocal, std::span<const std::uint32_t> indices);
    EmbreeScene(EmbreeScene&&) noexcept;
    EmbreeScene& operator=(EmbreeScene&&) noexcept;
    ~EmbreeScene();

    // Offers every triangle that comes within margin() of the ray, in no particular order and perhaps with others, to
    // `blocks` until it says yes. Says whether it did.
    using Blocks = bool (*)(void* query, std::uint32_t triangle);
    bool anyBlocks(const SearchRay& ray, Blocks blocks, void* query) const;

    // Offers every triangle that comes within margin() of the ray before the nearest hit so far, in no particular order and
    // perhaps with others, to `meets`, which gives the hit's t of the SearchRay, or nothing.
    using Meets = std::optional<double> (*)(void* query, std::uint32_t triangle);
    void offerUpToNearest(const SearchRay& ray, Meets meets, void* query) const;

    // The bound on float rounding that triangles are widened by where they are offered; Local units. Rays whose origin lies
    // within the scene's box, widened by twice the margin, lose nothing.
    double margin() const;

    // The first hit of each ray that `keeps` agrees to, by float arithmetic that leaves no gaps between neighbours.
    // Rays next to each other should lie close together. Without `keeps` every hit is agreed to.
    using Keeps = bool (*)(const void* owner, std::uint32_t triangle, float u, float v);
    void nearest(std::span<const SearchRay> rays, std::span<SearchHit> hits, Keeps keeps, const void* owner) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lixel
