// SPDX-License-Identifier: MIT
// What an observation takes from a picture and what it marks (lixel/base/observation.h): one text for C++ and for GLSL.
// Products, sums and comparisons in a fixed order only, so that both come to the same bits.
#ifndef LIXEL_SHARED_OBSERVE_H
#define LIXEL_SHARED_OBSERVE_H
#include "lixel/shared/shading.h"
#include "lixel/shared/view_tables.h"

LX_SHARED_BEGIN

// One cell of the grid (std430); `point.pixel` is kNoPixel where its pixel sees nothing.
struct ObservedPoint
{
    ViewPoint point;
    uint lit, facing, atBoundary; // bit i: of light i
    uint atDepthJump;             // 1 or 0
};

// The pixel, along one side of the picture, that is nearest to the centre of a cell of that side.
LX_FN int lxPixelOfCell(int cell, int cells, int pixels) { return ((2 * cell + 1) * pixels) / (2 * cells); }

// Whether the light can reach a surface point at all, by isLightFacing()'s rule.
LX_FN bool lxFaces(ShadingLight light, vec3 positionLocal, vec3 normal)
{
    LX_PRECISE float x = light.place.x - light.place.w * positionLocal.x;
    LX_PRECISE float y = light.place.y - light.place.w * positionLocal.y;
    LX_PRECISE float z = light.place.z - light.place.w * positionLocal.z;
    LX_PRECISE float facing = normal.x * x + normal.y * y + normal.z * z;
    LX_PRECISE float distance2 = x * x + y * y + z * z;
    LX_PRECISE float range2 = light.colour.w * light.colour.w;
    LX_PRECISE float along = -(light.axis.x * x + light.axis.y * y + light.axis.z * z);
    LX_PRECISE float along2 = along * along;
    LX_PRECISE float onCone2 = light.axis.w * light.axis.w * distance2;
    bool isInRange = light.colour.w == 0.0f || distance2 <= range2;
    bool isInCone = light.axis.w < -1.0f || (along >= 0.0f && along2 >= onCone2);
    return facing > 0.0f && isInRange && isInCone;
}

// Visibility rounded: 0.5 is lit, and so is what no region serves (below 0).
LX_FN bool lxIsLit(float visibility) { return visibility < 0.0f || visibility >= 0.5f; }

// Sines of angles, of the line between two samples with their planes. Below the first the sample counts as in the plane;
// two that do not add up to the second are a bend of one surface.
const float LX_IN_PLANE = 0.001f;
const float LX_BEND = 0.15f;

// Whether two neighbouring samples of a picture lie on different surfaces. Along the line of pixels between them, each
// tangent plane predicts a depth (in NDC, linear in the picture). Where the surface bends or has an edge between them, the
// predictions cross there: towards the eye, each sample is behind the other's plane; away from it, each is before. Where
// one sample is behind the other's plane and that one before its own, one prediction is nearer all the way, and depth jumps.
LX_FN bool lxIsDepthJump(vec3 pointA, vec3 normalA, vec3 pointB, vec3 normalB)
{
    LX_PRECISE float x = pointB.x - pointA.x;
    LX_PRECISE float y = pointB.y - pointA.y;
    LX_PRECISE float z = pointB.z - pointA.z;
    LX_PRECISE float distance2 = x * x + y * y + z * z;
    LX_PRECISE float beforeA = normalA.x * x + normalA.y * y + normalA.z * z;    // B, from A's plane towards the eye
    LX_PRECISE float beforeB = -(normalB.x * x + normalB.y * y + normalB.z * z); // A, from B's plane
    LX_PRECISE float apart = abs(beforeA) + abs(beforeB);
    LX_PRECISE float a2 = beforeA * beforeA;
    LX_PRECISE float b2 = beforeB * beforeB;
    LX_PRECISE float apart2 = apart * apart;
    LX_PRECISE float inPlane2 = LX_IN_PLANE * LX_IN_PLANE * distance2;
    LX_PRECISE float bend2 = LX_BEND * LX_BEND * distance2;
    bool areOpposite = (beforeA < 0.0f) != (beforeB < 0.0f);
    return areOpposite && a2 > inPlane2 && b2 > inPlane2 && apart2 > bend2;
}

LX_SHARED_END

#endif
