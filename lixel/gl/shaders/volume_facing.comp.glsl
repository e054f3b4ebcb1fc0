// SPDX-License-Identifier: MIT
// Which side of each triangle the light sees: 1 the one round which its corners run counterclockwise, -1 the other, 0 neither.
// It is decided once and holds for the triangle's caps and all its sides, so that its volume is closed however it is rounded.
#include "lixel/gl/shaders/volume_casters.glsl"
#include "lixel/gl/shaders/volume_index.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = kStorageFacing) writeonly buffer Facing { int facing[]; };
layout(location = 1) uniform uint triangleCount;

void main()
{
    uint triangle = indexInRows();
    if (triangle >= triangleCount) return;
    vec3 a = cornerAt(indices[3u * triangle]);
    vec3 b = cornerAt(indices[3u * triangle + 1u]), c = cornerAt(indices[3u * triangle + 2u]);
    float above = dot(cross(b - a, c - a), lightLocal.xyz - lightLocal.w * a);
    facing[triangle] = above > 0.0 ? 1 : above < 0.0 ? -1 : 0;
}
