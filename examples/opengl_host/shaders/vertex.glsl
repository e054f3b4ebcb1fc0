// SPDX-License-Identifier: MIT
// This renderer's vertex format; before the main() of every vertex shader.
layout(location = 0) in vec3 position; // a fraction of the mesh's box
layout(location = 1) in uint colour565;
layout(location = 2) in vec2 normalFolded;

uniform vec3 meshLowLocal, meshSize;

vec3 decodedPosition() { return meshLowLocal + meshSize * position; }

vec3 decodedColour()
{
    return vec3(colour565 >> 11, colour565 >> 5 & 63u, colour565 & 31u) / vec3(31, 63, 31);
}

vec3 decodedNormal()
{
    vec3 n = vec3(normalFolded, 1.0 - abs(normalFolded.x) - abs(normalFolded.y));
    vec2 side = vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * side;
    return normalize(n);
}
