// SPDX-License-Identifier: MIT
// Depth alone.   POSITION   and where the surface is
#ifdef POSITION
layout(location = 3) in vec3 surfaceLocal;
layout(location = 0) out vec4 drawnLocal; // w: 1 where something is drawn

void main() { drawnLocal = vec4(surfaceLocal, 1.0); }
#else
void main() {}
#endif
