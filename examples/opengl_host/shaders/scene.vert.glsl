// SPDX-License-Identifier: MIT
uniform mat4 clipFromLocal;

out vec3 positionLocal;
flat out vec3 normal;
out vec3 colour;

void main()
{
    positionLocal = decodedPosition();
    normal = decodedNormal();
    colour = decodedColour();
    gl_Position = clipFromLocal * vec4(positionLocal, 1.0);
}
