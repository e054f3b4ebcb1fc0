// SPDX-License-Identifier: MIT
// Both ends of shadow volumes: the triangles themselves, and the same infinitely far away.
//   FAR   the far ends
#include "lixel/gl/shaders/volume_casters.glsl"
#include "lixel/gl/shaders/volume_clip.glsl"

layout(std430, binding = kStorageFacing) readonly buffer Facing { int facing[]; };

#ifndef FAR
#include "lixel/gl/shaders/volume_plane.glsl"
#endif

void main()
{
    uint vertex = uint(gl_VertexID), triangle = vertex / 3u;
    int seen = facing[triangle];
    if (seen == 0) { // seen from the light it has no inside
        gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
        return;
    }
    // Outside is up at the near end and down at the far one.
#ifdef FAR
    bool isTurned = seen > 0;
#else
    bool isTurned = seen < 0;
#endif
    uint corner = vertex % 3u;
    if (isTurned) corner = (3u - corner) % 3u;
    vec3 cornerLocal = cornerAt(indices[3u * triangle + corner]);
#ifdef FAR
    gl_Position = clipFromLocal * farAway(cornerLocal);
#else
    gl_Position = clipFromLocal * vec4(cornerLocal, 1.0);
    vec3 a = cornerAt(indices[3u * triangle]);
    vec3 ab = cornerAt(indices[3u * triangle + 1u]) - a, ac = cornerAt(indices[3u * triangle + 2u]) - a;
    tellPlane(triangle, a, float(seen) * ab, ac);
#endif
}
