// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/light_projection.h"

#include <optional>

namespace lixel {

// Lixels [x0, x1) x [y0, y1) of one layer of the atlas.
struct LixelRectangle
{
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int layer = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    friend bool operator==(const LixelRectangle&, const LixelRectangle&) = default;
};

struct TextureWarp; // warp/texture_warp.h

// A ray of light in Local space: a point of it and the way light travels, not normalised. On a paraboloid the point is the light.
struct LightRay
{
    Vec3d originLocal;
    Vec3d directionLocal;
};

// The image that a light has of a region: the fit, then the warp, in its rectangle of the atlas.
// Continuous lixel coordinates count from the layer's corner; lixel (i, j) has its centre at (i + 1/2, j + 1/2). Warps are those of
// lixel/shared/warp.h, in float as lookups have them, so that the ray through a lixel is the very one that lookups take a tap for.
class LightImage
{
public:
    // The warp is kept by address; null: none.
    LightImage(const LightProjection& projection, const LixelRectangle& rectangle, const TextureWarp* warp = nullptr);

    // x, y: lixel; z: NDC depth in [-1, +1], growing away from the light. Nothing where no ray goes or outside the rectangle.
    std::optional<Vec3d> lixelAt(Vec3d pointLocal) const;

    // The ray through a point of the light image. Nothing where the matrix has no inverse.
    std::optional<LightRay> rayThrough(Vec2d lixel) const;

    // How the receiver plane through the point lies in the light image: d lixel / d plane and d depth / d plane along two
    // unit tangents of the plane. Needs a point that lixelAt() has a place for.
    struct Tangents
    {
        Vec3d lixelAndDepthAlongFirst, lixelAndDepthAlongSecond;
    };
    Tangents tangents(Vec3d pointLocal, Vec3d first, Vec3d second) const;

private:
    Vec3d unwarpedAt(Vec3d ndc) const;

    LightProjection projection_;
    std::optional<Mat4d> localFromLightClip_; // of a matrix alone
    LixelRectangle rectangle_;
    const TextureWarp* warp_; // null: the identity
};

} // namespace lixel
