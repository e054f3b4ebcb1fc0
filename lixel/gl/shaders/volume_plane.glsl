// SPDX-License-Identifier: MIT
// The plane of a near end or of a side of shadow volumes, for volume_boundary.frag.glsl.

layout(location = 0) flat out uint outTriangle;
layout(location = 1) flat out vec3 outOnPlaneLocal;
layout(location = 2) flat out vec3 outOutwards;
layout(location = 3) flat out float outRounding;

// A sample is off its plane by up to sqrt(3) 2^-24 of its largest coordinate, its distance by some 2^-22 of how far it is from the
// point on the plane, and more where a sliver's normal is unsure.
const float kPlaneRounding = 1.0 / 4194304.0;

const uint kNoOwnSamples = 0xfffffffeu; // nor is it what samples without a triangle have

vec3 scaled(vec3 a) { return a / max(abs(a.x), max(abs(a.y), abs(a.z))); } // squares of far lights would be infinite

// Through a point; a and b span it, and outwards is up where they turn counterclockwise.
void tellPlane(uint triangle, vec3 onPlaneLocal, vec3 a, vec3 b)
{
    a = scaled(a), b = scaled(b);
    vec3 normal = cross(a, b);
    float area = length(normal);
    outTriangle = triangle;
    outOnPlaneLocal = onPlaneLocal;
    outOutwards = normal / area;
    outRounding = kPlaneRounding * max(1.0, 0.5 * length(a) * length(b) / area);
}
