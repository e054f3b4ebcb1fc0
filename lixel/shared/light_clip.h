// SPDX-License-Identifier: MIT
// From Local space to a region's clip space: one text for casters and receivers, for the CPU executor and for GLSL. A host whose GLSL has no
// doubles defines LIXEL_NO_DOUBLE; then lixels of flat light (place.w) are up to a tenth beside their place.
#ifndef LIXEL_SHARED_LIGHT_CLIP_H
#define LIXEL_SHARED_LIGHT_CLIP_H
#include "lixel/shared/shadow_tables.h"

LX_SHARED_BEGIN

#ifndef LIXEL_NO_DOUBLE
// One row of a matrix, in two parts, at a point.
LX_FN float lxRowInDouble(vec4 high, vec4 low, vec3 p)
{
    return float((double(high.x) + double(low.x)) * double(p.x) + (double(high.y) + double(low.y)) * double(p.y) +
                 (double(high.z) + double(low.z)) * double(p.z) + (double(high.w) + double(low.w)));
}
#endif

LX_FN vec4 lxLightClip(ShadowRegion region, vec3 positionLocal)
{
    mat4 m = region.lightClipFromLocal;
#ifndef LIXEL_NO_DOUBLE
    if (region.place.w > 0.0f) {
        mat4 l = region.lightClipLow;
        return vec4(
            lxRowInDouble(vec4(m[0].x, m[1].x, m[2].x, m[3].x), vec4(l[0].x, l[1].x, l[2].x, l[3].x), positionLocal),
            lxRowInDouble(vec4(m[0].y, m[1].y, m[2].y, m[3].y), vec4(l[0].y, l[1].y, l[2].y, l[3].y), positionLocal),
            lxRowInDouble(vec4(m[0].z, m[1].z, m[2].z, m[3].z), vec4(l[0].z, l[1].z, l[2].z, l[3].z), positionLocal),
            lxRowInDouble(vec4(m[0].w, m[1].w, m[2].w, m[3].w), vec4(l[0].w, l[1].w, l[2].w, l[3].w), positionLocal));
    }
#endif
    return m * vec4(positionLocal, 1.0f);
}

LX_SHARED_END

#endif
