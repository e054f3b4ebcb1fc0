// SPDX-License-Identifier: MIT
// A direction in two numbers in [0, 1] (octahedral map: Meyer et al., On Floating-Point Normal Vectors, 2010). (0, 0) is
// kept for "no direction": the direction -z, which all four corners stand for, is written as (1, 1).

vec2 signs(vec2 v) { return vec2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0); }

vec2 octahedronFromDirection(vec3 d)
{
    vec3 n = d / (abs(d.x) + abs(d.y) + abs(d.z));
    vec2 folded = n.z >= 0.0 ? n.xy : (1.0 - abs(n.yx)) * signs(n.xy);
    vec2 stored = folded * 0.5 + 0.5;
    return stored.x + stored.y < 1e-4 ? vec2(1.0) : stored;
}

bool isNoDirection(vec2 stored) { return stored == vec2(0.0); }

vec3 directionFromOctahedron(vec2 stored)
{
    vec2 f = stored * 2.0 - 1.0;
    vec3 d = vec3(f, 1.0 - abs(f.x) - abs(f.y));
    if (d.z < 0.0) d.xy = (1.0 - abs(d.yx)) * signs(d.xy);
    return normalize(d);
}
