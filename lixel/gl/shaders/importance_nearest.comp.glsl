// SPDX-License-Identifier: MIT
// The least squared distance of a sample to the eye, as bits, which grow with it.
#include "lixel/gl/shaders/importance_points.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageNearest) buffer Nearest { uint nearest2; };

const uint kSamplesEach = 64u;

void main()
{
    uint first = gl_WorkGroupID.x * gl_WorkGroupSize.x * kSamplesEach + gl_LocalInvocationID.x;
    float least = 3.0e38;
    for (uint k = 0u; k < kSamplesEach; ++k) {
        uint entry = first + k * gl_WorkGroupSize.x;
        if (entry < pointCount && points[entry].pixel != kNoPixel) least = min(least, distance2ToEye(points[entry].positionLocal));
    }
    atomicMin(nearest2, floatBitsToUint(least));
}
