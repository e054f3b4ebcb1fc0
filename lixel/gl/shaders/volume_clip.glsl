// SPDX-License-Identifier: MIT
// The view, with a depth of its own that falls from 1 at the nearest distance to 0 at infinity, so that nothing is cut off far
// away: nearest / w.

layout(location = 2) uniform mat4 clipFromLocal; // rows x, y and w of the view, z = nearest
