// SPDX-License-Identifier: MIT
// Which texels a surface's alpha comes from and how they blend: one rule for rays, for shaders and for their tests.
//
//   alpha = factor * vertex colour's alpha * base level, bilinear between texel centres at i + 1/2, the sampler's wrap,
//   no mips; the surface is kept where alpha >= cutoff.
//
// A coordinate is folded into [0, 1] first, so that no size of uv overflows an integer; then the texel below it and the
// next one are blended. For each axis:
//
//   folded = foldCoordinate(u, wrap)
//   i0 = wrapTexel(texelBelow(folded, size), size, wrap), i1 = wrapTexel(texelBelow(folded, size) + 1, size, wrap)
//   t  = texelBlend(folded, size)                             value = value(i0) * (1 - t) + value(i1) * t
#ifndef LIXEL_SHARED_ALPHA_H
#define LIXEL_SHARED_ALPHA_H
#include "lixel/shared/glsl.h"

LX_SHARED_BEGIN

// The values of lixel::Wrap, in its order.
const int kWrapRepeat = 0;
const int kWrapMirroredRepeat = 1;
const int kWrapClampToEdge = 2;

// Into [0, 1]; what is not a number becomes 0.
LX_FN float foldCoordinate(float u, int wrap)
{
    float folded = u;
    if (wrap == kWrapRepeat) folded = u - floor(u);
    if (wrap == kWrapMirroredRepeat) {
        folded = u - 2.0f * floor(0.5f * u);
        if (folded > 1.0f) folded = 2.0f - folded;
    }
    if (!(folded >= 0.0f)) folded = 0.0f;
    if (folded > 1.0f) folded = 1.0f;
    return folded;
}

// From -1 to size - 1.
LX_FN int texelBelow(float folded, int size) { return int(floor(folded * float(size) - 0.5f)); }

// The weight of the texel above, in [0, 1).
LX_FN float texelBlend(float folded, int size)
{
    float position = folded * float(size) - 0.5f;
    return position - floor(position);
}

// An index from -1 to size, brought into the image. Mirroring repeats the edge texel, hence clamps here.
LX_FN int wrapTexel(int i, int size, int wrap)
{
    if (i < 0) return wrap == kWrapRepeat ? size - 1 : 0;
    if (i >= size) return wrap == kWrapRepeat ? 0 : size - 1;
    return i;
}

LX_FN float bilinear(float v00, float v10, float v01, float v11, float blendX, float blendY)
{
    float below = v00 * (1.0f - blendX) + v10 * blendX;
    float above = v01 * (1.0f - blendX) + v11 * blendX;
    return below * (1.0f - blendY) + above * blendY;
}

LX_FN bool isKept(float factorAlpha, float vertexAlpha, float textureAlpha, float cutoff)
{
    return factorAlpha * vertexAlpha * textureAlpha >= cutoff;
}

LX_SHARED_END

#endif
