// SPDX-License-Identifier: MIT
// Near ends and sides of shadow volumes, where they lie behind the sample. Which side of one it lies on is told from their places,
// not from the depth that the rasterizer finds for a triangle whose corners it moved to parts of a pixel. What lies in its plane as
// far as floats tell is taken for a little nearer to the eye, with each of them: so it is with a triangle and its own samples.
#include "lixel/shared/gl_slots.h"

layout(binding = kUnitSamples) uniform usampler2D samples;

layout(location = 0) flat in uint triangle; // of a near end
layout(location = 1) flat in vec3 onPlaneLocal;
layout(location = 2) flat in vec3 outwards; // unit
layout(location = 3) flat in float rounding; // of distances from the plane, per largest coordinate

void main()
{
    uvec4 ofPixel = texelFetch(samples, ivec2(gl_FragCoord.xy), 0);
    vec3 sampleLocal = uintBitsToFloat(ofPixel.xyz);
    vec3 largest = max(abs(sampleLocal), abs(onPlaneLocal));
    float height = dot(outwards, sampleLocal - onPlaneLocal);
    bool isInPlane = !(abs(height) > rounding * max(largest.x, max(largest.y, largest.z)));
    bool isBehind = ofPixel.w == triangle || isInPlane || (height > 0.0) == gl_FrontFacing;
    if (!isBehind) discard;
}
