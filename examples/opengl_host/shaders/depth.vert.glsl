// SPDX-License-Identifier: MIT
// Own shadow maps: one region a draw.
uniform mat4 clipFromLocal;

void main() { gl_Position = clipFromLocal * vec4(decodedPosition(), 1.0); }
