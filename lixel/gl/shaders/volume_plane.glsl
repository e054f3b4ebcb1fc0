// SPDX-License-Identifier: MIT
// The plane of a near end or of a side of shadow volumes, for volume_boundary.frag.glsl.

layout(location = 0) flat out uint outTriangle;
layout(location = 1) flat out vec3 outOnPlaneLocal;
layout(location = 2) flat out vec3 outOutwards;
layout(location = 3) flat out float outRounding;

// As exact visibility tells one flat surface; more for slivers, whose normal is unsure.
const float kCornerRounding = 1.0 / 4194304.0;

const uint kNoTriangle = 0xfffffffeu; // no sample's either

// Through a point; a and b span it, and outwards is up where they turn counterclockwise.
void tellPlane(uint triangle, vec3 onPlaneLocal, vec3 a, vec3 b)
{
    vec3 normal = cross(a, b);
    float area = length(normal);
    outTriangle = triangle;
    outOnPlaneLocal = onPlaneLocal;
    outOutwards = normal / area;
    outRounding = kCornerRounding * max(1.0, 0.5 * length(a) * length(b) / area);
}
