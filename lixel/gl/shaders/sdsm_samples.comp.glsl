// SPDX-License-Identifier: MIT
// Reduces the view samples that face the light: to their nearest and farthest depth, or with BOUNDS to what each cascade holds. Every
// invocation looks at several samples, a workgroup apart, and tells of them at once where they lie in one cascade.
#include "lixel/gl/shaders/sdsm.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = kStoragePoints) readonly buffer Points { ViewPoint points[]; };

layout(location = 0) uniform uint pointCount; // in this part of the list

const uint kSamplesEach = 64u;

#ifdef BOUNDS
float splits[17];
int cascade = -1; // the one that the values below are of
vec4 least;          // x, y, -x, -y
vec3 greatestOthers; // depth along the light, terms of x and y

void tell()
{
    if (cascade < 0) return;
    int first = kCascades + kOfCascade * cascade;
    raise(first, -least.x);
    raise(first + 1, -least.y);
    raise(first + 2, -least.z);
    raise(first + 3, -least.w);
    raise(first + 4, greatestOthers.x);
    raise(first + 5, greatestOthers.y);
    raise(first + 6, greatestOthers.z);
}

void begin()
{
    for (int i = 0; i <= int(setup.regions.y); ++i)
        splits[i] = lxSdsmSplit(setup, nearestDepth(), farthestDepth(), i);
}

void look(vec3 p, float depth)
{
    int count = int(setup.regions.y);
    float x = lxSdsmAt(setup.lightX, p), y = lxSdsmAt(setup.lightY, p);
    vec4 onPlane = vec4(x, y, -x, -y);
    vec3 others = vec3(lxSdsmAt(setup.lightDepth, p), lxSdsmTerms(setup.lightX, p), lxSdsmTerms(setup.lightY, p));
    for (int i = 0; i < count; ++i) {
        if (!lxSdsmHolds(setup, i, splits[i], splits[i + 1], depth)) continue;
        if (i == cascade) {
            least = min(least, onPlane);
            greatestOthers = max(greatestOthers, others);
            continue;
        }
        tell();
        cascade = i;
        least = onPlane;
        greatestOthers = others;
    }
}
#else
float nearest, farthest;
bool isAny = false;

void begin() {}

void tell()
{
    if (!isAny) return;
    raise(kNearest, -nearest);
    raise(kFarthest, farthest);
}

void look(vec3 p, float depth)
{
    nearest = isAny ? min(nearest, depth) : depth;
    farthest = isAny ? max(farthest, depth) : depth;
    isAny = true;
}
#endif

void main()
{
    begin();
    uint first = gl_WorkGroupID.x * gl_WorkGroupSize.x * kSamplesEach + gl_LocalInvocationID.x;
    for (uint k = 0u; k < kSamplesEach; ++k) {
        uint entry = first + k * gl_WorkGroupSize.x;
        if (entry >= pointCount) break;
        ViewPoint point = points[entry];
        if (point.pixel == kNoPixel || !lxFaces(setup.light, point.positionLocal, point.normal)) continue;
        look(point.positionLocal, lxSdsmAt(setup.viewDepth, point.positionLocal));
    }
    tell();
}
