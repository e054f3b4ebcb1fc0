// SPDX-License-Identifier: MIT
// Forward lighting, behind lixel_lookup.glsl, whose five questions are answered first.
layout(std430, binding = 0) readonly buffer Regions { ShadowRegion regions[]; };
layout(std430, binding = 1) readonly buffer HalfSpaces { vec4 halfSpaces[]; };
layout(std430, binding = 2) readonly buffer ShadowLights { ShadowLight shadowLights[]; };
uniform sampler2DArray atlas;

ShadowRegion lxRegionAt(int index) { return regions[index]; }
vec4 lxHalfSpaceAt(int index) { return halfSpaces[index]; }
float lxWarpKnot(int index) { return 0.0; } // it draws maps without a warp only
ShadowLight lxLightAt(int index) { return shadowLights[index]; }
float lxStoredDepth(int x, int y, int layer) { return texelFetch(atlas, ivec3(x, y, layer), 0).r; }

struct HostLight
{
    vec4 place;  // xyz: position (w = 1), or the way towards the light (w = 0)
    vec4 axis;   // xyz: of a spot; w: cosine of half its cone, -2 without
    vec4 colour; // w: range, 0 without
};
layout(std430, binding = 3) readonly buffer HostLights { HostLight hostLights[]; };
uniform int tapsPerSide;

in vec3 positionLocal;
flat in vec3 normal;
in vec3 colour;
layout(location = 0) out vec4 result;

// How much of the light arrives where nothing is in its way.
float unshadowed(HostLight light)
{
    vec3 towards = light.place.xyz - light.place.w * positionLocal;
    float cosine = dot(normal, normalize(towards));
    float inCone = smoothstep(light.axis.w, light.axis.w + 0.05, -dot(light.axis.xyz, normalize(towards)));
    float near = light.colour.w > 0.0 ? clamp(1.0 - length(towards) / light.colour.w, 0.0, 1.0) : 1.0;
    return max(cosine, 0.0) * (light.axis.w < -1.0 ? 1.0 : inCone) * near * near;
}

void main()
{
    vec3 sum = mix(vec3(0.05, 0.045, 0.04), vec3(0.12, 0.15, 0.20), 0.5 + 0.5 * normal.y);
    for (int i = 0; i < hostLights.length(); ++i) {
        float arriving = unshadowed(hostLights[i]);
        if (arriving <= 0.0) continue;
        float visibility = lixelVisibility(i, positionLocal, normal, tapsPerSide);
        if (visibility != kLixelUnserved) arriving *= visibility;
        sum += arriving * hostLights[i].colour.rgb;
    }
    result = vec4(pow(1.0 - exp(-colour * sum), vec3(1.0 / 2.2)), 1.0);
}
