// SPDX-License-Identifier: MIT
// The box of a triangle in the region's NDC, as far as it lies before the light.

const float kFarAway = 3.0e38;
const float kBoxRounding = 1.0e-6;

struct Box
{
    vec2 least, greatest;
};

Box withCorner(Box box, vec4 clip)
{
    if (clip.w <= 0.0) return box;
    vec2 ndc = clip.xy / clip.w;
    return Box(min(box.least, ndc), max(box.greatest, ndc));
}

// Towards a corner that is not before the light an edge goes on for ever, as the light sees it.
Box withEdge(Box box, vec4 from, vec4 to)
{
    if (from.w <= 0.0 || to.w > 0.0) return box;
    vec2 way = to.xy * from.w - from.xy * to.w;
    if (way.x >= 0.0) box.greatest.x = kFarAway;
    if (way.x <= 0.0) box.least.x = -kFarAway;
    if (way.y >= 0.0) box.greatest.y = kFarAway;
    if (way.y <= 0.0) box.least.y = -kFarAway;
    return box;
}

// Least x, y, greatest x, y, cut to the map; least > greatest where nothing of it is there.
vec4 boxInMap(vec4 a, vec4 b, vec4 c)
{
    Box box = withCorner(withCorner(withCorner(Box(vec2(kFarAway), vec2(-kFarAway)), a), b), c);
    if (min(a.w, min(b.w, c.w)) <= 0.0) {
        box = withEdge(withEdge(box, a, b), b, a);
        box = withEdge(withEdge(box, b, c), c, b);
        box = withEdge(withEdge(box, c, a), a, c);
    }
    return vec4(max(box.least - kBoxRounding, vec2(-1.0)), min(box.greatest + kBoxRounding, vec2(1.0)));
}

// Nearer corners than the far side have depths above 0; farther ones draw nothing.
bool isBeyondFarSide(vec4 a, vec4 b, vec4 c)
{
    return a.w > 0.0 && b.w > 0.0 && c.w > 0.0 && a.z < 0.0 && b.z < 0.0 && c.z < 0.0;
}
