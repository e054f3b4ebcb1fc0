// SPDX-License-Identifier: MIT
// What the view sees, for techniques that are made from it.
in vec3 positionLocal;
flat in vec3 normal;

layout(location = 0) out vec4 seenPosition; // w: 1 where something is seen
layout(location = 1) out vec4 seenNormal;

void main()
{
    seenPosition = vec4(positionLocal, 1.0);
    seenNormal = vec4(normal, 0.0);
}
