// SPDX-License-Identifier: MIT
// The alpha of a surface's texture by the one rule of lixel/shared/alpha.h.
#include "lixel/shared/alpha.h"
#include "lixel/shared/gl_slots.h"

layout(binding = kUnitSurface) uniform sampler2D surfaceTexture;
layout(location = 8) uniform ivec2 surfaceWrap; // of u and v

// The byte that is stored, over 255, whatever way the driver turns bytes into floats.
float storedAlpha(int x, int y)
{
    return floor(texelFetch(surfaceTexture, ivec2(x, y), 0).a * 255.0 + 0.5) / 255.0;
}

float surfaceTextureAlpha(vec2 uv)
{
    ivec2 size = textureSize(surfaceTexture, 0);
    float u = foldCoordinate(uv.x, surfaceWrap.x), v = foldCoordinate(uv.y, surfaceWrap.y);
    int x = texelBelow(u, size.x), y = texelBelow(v, size.y);
    int x0 = wrapTexel(x, size.x, surfaceWrap.x), x1 = wrapTexel(x + 1, size.x, surfaceWrap.x);
    int y0 = wrapTexel(y, size.y, surfaceWrap.y), y1 = wrapTexel(y + 1, size.y, surfaceWrap.y);
    return bilinear(storedAlpha(x0, y0), storedAlpha(x1, y0), storedAlpha(x0, y1), storedAlpha(x1, y1),
                    texelBlend(u, size.x), texelBlend(v, size.y));
}
