// SPDX-License-Identifier: MIT
// What a lookup makes of a region's map, a lixel an invocation: WORDS several depths, GRADIENTS slopes, ACROSS and ALONG moments, the
// second from the first.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/shadow_tables.h"
#include "lixel/shared/lookup/stored_depths.h"

layout(binding = kUnitAtlas) uniform sampler2DArray atlas;
layout(binding = kUnitMoments) uniform sampler2DArray across;
float lxStoredDepth(int x, int y, int layer) { return texelFetch(atlas, ivec3(x, y, layer), 0).r; }
vec4 lxStoredMoments(int x, int y, int layer) { return texelFetch(across, ivec3(x, y, layer), 0); }
#include "lixel/shared/lookup/blur.h"
#include "lixel/shared/lookup/gradient.h"
#include "lixel/shared/lookup/select_depths.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = kStorageRegions) readonly buffer Regions { ShadowRegion regions[]; };
layout(location = 0) uniform int region;
const int tapsPerSide = 1; // which nothing here depends on

#if defined(WORDS)
layout(binding = kImagePrepared) writeonly uniform uimage2DArray words;
layout(binding = kImageMoreWords) writeonly uniform uimage2DArray moreWords;
#elif defined(GRADIENTS)
layout(binding = kImagePrepared) writeonly uniform uimage2DArray gradients;
#else
layout(binding = kImagePrepared) writeonly uniform image2DArray moments;
#endif

void main()
{
    vec4 rectangle = regions[region].rectangle;
    float bend = regions[region].projection.z;
    int layer = int(regions[region].place.x);
    int x = int(rectangle.x) + int(gl_GlobalInvocationID.x);
    int y = int(rectangle.y) + int(gl_GlobalInvocationID.y);
    if (x >= int(rectangle.z) || y >= int(rectangle.w)) return;
    LxLookup how = LOOKUP;
    ivec3 lixel = ivec3(x, y, layer);
#if defined(WORDS)
    LxWords prepared = lxPackedDepths(how, rectangle, bend, x, y, layer);
    imageStore(words, lixel, prepared.words);
    if (how.depths > 6) imageStore(moreWords, lixel, uvec4(prepared.more));
#elif defined(GRADIENTS)
    imageStore(gradients, lixel, uvec4(lxPackedGradient(lxGradient(rectangle, x, y, layer))));
#elif defined(ACROSS)
    imageStore(moments, lixel, lxMomentsAcross(how, rectangle, bend, x, y, layer));
#else
    imageStore(moments, lixel, lxMomentsAlong(how, rectangle, x, y, layer));
#endif
}
