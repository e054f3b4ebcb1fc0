// SPDX-License-Identifier: MIT
// How pictures are lit and shown: one text for the CPU executor and for GLSL. Diffuse surfaces under point-like lights and a
// sky; light has no falloff with distance but towards the end of its range, so that a light's colour is what it gives.
#ifndef LIXEL_SHARED_SHADING_H
#define LIXEL_SHARED_SHADING_H
#include "lixel/shared/glsl.h"

LX_SHARED_BEGIN

// One light (std430).
struct ShadingLight
{
    vec4 place;  // xyz: its position, Local (w = 1), or the unit direction towards it (w = 0)
    vec4 axis;   // xyz: of a spot, unit, the way light travels; w: cosine of half its cone, -2 where there is no cone
    vec4 colour; // rgb; w: range, 0 where it has none
};

// The share of a spot's cone, by cosine, in which its light fades out.
const float LX_CONE_FADE = 0.1f;

// What a light that nothing blocks adds to a white surface: 0 where the geometric normal faces away, outside cone and range.
LX_FN vec3 lxDirectLight(ShadingLight light, vec3 positionLocal, vec3 geometricNormal, vec3 shadingNormal)
{
    vec3 place = vec3(light.place.x, light.place.y, light.place.z);
    vec3 toLight = place - light.place.w * positionLocal;
    float distance = length(toLight);
    vec3 l = toLight / distance;
    float cosine = dot(geometricNormal, l) > 0.0f ? max(dot(shadingNormal, l), 0.0f) : 0.0f;

    float inCone = -dot(vec3(light.axis.x, light.axis.y, light.axis.z), l);
    float fade = LX_CONE_FADE * (1.0f - light.axis.w);
    float cone = light.axis.w < -1.0f ? 1.0f : clamp((inCone - light.axis.w) / fade, 0.0f, 1.0f);
    float window = 1.0f;
    if (light.colour.w > 0.0f) {
        float q = distance / light.colour.w;
        float rest = clamp(1.0f - q * q * q * q, 0.0f, 1.0f);
        window = rest * rest;
    }
    return cosine * cone * window * vec3(light.colour.x, light.colour.y, light.colour.z);
}

// What sky and ground add to a white surface; the sky is where y grows.
LX_FN vec3 lxAmbientLight(vec3 normal)
{
    return mix(vec3(0.10f, 0.09f, 0.08f), vec3(0.20f, 0.23f, 0.28f), 0.5f + 0.5f * normal.y);
}

// Behind all surfaces, linear; `height` is 0 at the picture's bottom, 1 at its top.
LX_FN vec3 lxBackground(float height) { return mix(vec3(0.56f, 0.62f, 0.68f), vec3(0.24f, 0.38f, 0.60f), height); }

// K. Narkowicz, ACES Filmic Tone Mapping Curve, 2015: a fit of the ACES reference transforms.
LX_FN float lxToneMapped(float linear)
{
    float x = max(linear, 0.0f);
    return clamp((x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
}

// IEC 61966-2-1.
LX_FN float lxSrgbFromLinear(float linear)
{
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * pow(linear, 1.0f / 2.4f) - 0.055f;
}

// A linear colour as a display takes it, each in [0, 1].
LX_FN vec3 lxDisplayed(vec3 linear)
{
    return vec3(lxSrgbFromLinear(lxToneMapped(linear.x)), lxSrgbFromLinear(lxToneMapped(linear.y)),
                lxSrgbFromLinear(lxToneMapped(linear.z)));
}

LX_SHARED_END

#endif
