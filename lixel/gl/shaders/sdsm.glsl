// SPDX-License-Identifier: MIT
// What the passes that make sdsm's tables share: the greatest values found so far, as integers that atomics can compare.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/sdsm.h"

layout(std140, binding = kUniformSdsm) uniform Setup { SdsmSetup setup; };
layout(std430, binding = kStorageSdsm) buffer Greatest { uint greatest[]; };

// Of the whole: nearest depth, turned round, and farthest; of each cascade: least x and y, turned round, greatest x and y, the
// farthest depth along the light, and the greatest terms of x and y.
const int kNearest = 0;
const int kFarthest = 1;
const int kCascades = 2;
const int kOfCascade = 7;

// Keeps the order of floats; 0 is below all of them.
uint ordered(float value)
{
    uint bits = floatBitsToUint(value);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float fromOrdered(uint bits) { return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7fffffffu : ~bits); }

void raise(int entry, float value) { atomicMax(greatest[entry], ordered(value)); }

bool isAnythingSeen() { return greatest[kFarthest] != 0u; }
float nearestDepth() { return -fromOrdered(greatest[kNearest]); }
float farthestDepth() { return fromOrdered(greatest[kFarthest]); }
