// SPDX-License-Identifier: MIT
// A sample's own triangle never shadows it: its cap lies behind the sample, however the two depths are rounded.
#include "lixel/shared/gl_slots.h"

layout(binding = kUnitTriangles) uniform usampler2D sampleTriangles;

layout(location = 0) flat in uint triangle;

void main()
{
    bool isOwn = texelFetch(sampleTriangles, ivec2(gl_FragCoord.xy), 0).r == triangle;
    gl_FragDepth = isOwn ? 0.0 : gl_FragCoord.z;
}
