// SPDX-License-Identifier: MIT
// Sides of shadow volumes, from an edge to infinity: four corners, or three where all light rays end in one point there. Seen from
// outside they run counterclockwise.
#include "lixel/gl/shaders/volume_casters.glsl"
#include "lixel/gl/shaders/volume_clip.glsl"
#include "lixel/gl/shaders/volume_edges.glsl"
#include "lixel/gl/shaders/volume_plane.glsl"

layout(std430, binding = kStorageSides) readonly buffer Sides { uint sides[]; };
layout(location = 1) uniform uint verticesASide;

// Upper corner `from`, lower `from`, lower `to`, upper `to`; the lower two are one where there are three.
const uint kFan[6] = uint[6](0u, 1u, 2u, 0u, 2u, 3u);
const uint kTriangle[3] = uint[3](0u, 1u, 3u);

void main()
{
    uint vertex = uint(gl_VertexID);
    uint side = sides[vertex / verticesASide], place = vertex % verticesASide;
    MeshEdge edge = edges[side >> 1];
    bool isTurned = (side & 1u) != 0u;
    uint corner = verticesASide == 6u ? kFan[place] : kTriangle[place];
    bool isAtFrom = corner < 2u;
    vec3 from = cornerAt(isTurned ? edge.to : edge.from), to = cornerAt(isTurned ? edge.from : edge.to);
    vec3 atEdge = isAtFrom ? from : to;
    bool isFar = corner == 1u || corner == 2u;
    gl_Position = clipFromLocal * (isFar ? farAway(atEdge) : vec4(atEdge, 1.0));
    tellPlane(kNoOwnSamples, from, farAway(from).xyz, to - from);
}
