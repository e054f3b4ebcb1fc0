// SPDX-License-Identifier: MIT
// The tables of the cascades, from what each of them holds: one invocation a cascade.
#include "lixel/gl/shaders/sdsm.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageRegions) buffer Regions { ShadowRegion regions[]; };
layout(std430, binding = kStorageHalfSpaces) writeonly buffer HalfSpaces { vec4 halfSpaces[]; };
layout(std430, binding = kStorageSdsmCasters) readonly buffer Casters { SdsmCasters casters[]; };

mat4 matrixOf(int cascade, vec4 rectangle)
{
    int first = kCascades + kOfCascade * cascade;
    if (greatest[first] == 0u) return lxSdsmNowhere();
    SdsmBounds bounds;
    bounds.onPlane = vec4(-fromOrdered(greatest[first]), -fromOrdered(greatest[first + 1]),
                          fromOrdered(greatest[first + 2]), fromOrdered(greatest[first + 3]));
    bounds.farthest = fromOrdered(greatest[first + 4]);
    bounds.termsX = fromOrdered(greatest[first + 5]);
    bounds.termsY = fromOrdered(greatest[first + 6]);
    float nearest = bounds.farthest;
    int count = int(setup.options.y);
    for (int i = 0; i < count; ++i)
        if (lxSdsmMeets(casters[i], bounds)) nearest = min(nearest, casters[i].depth.x);
    return lxSdsmMatrix(setup, bounds, nearest, rectangle);
}

void main()
{
    int cascade = int(gl_LocalInvocationID.x), count = int(setup.regions.y);
    if (cascade >= count) return;
    int region = int(setup.regions.x) + cascade;
    regions[region].lightClipFromLocal = matrixOf(cascade, regions[region].rectangle);
    if (cascade + 1 == count) return;
    halfSpaces[int(setup.regions.z) + cascade] =
        isAnythingSeen() ? lxSdsmHalfSpace(setup, nearestDepth(), farthestDepth(), cascade)
                         : vec4(0.0, 0.0, 0.0, -1.0);
}
