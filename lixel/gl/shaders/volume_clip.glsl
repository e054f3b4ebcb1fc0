// SPDX-License-Identifier: MIT
// The view, with nothing cut off far away: z is the nearest distance, so that z / w falls from 1 there to 0 at infinity.

layout(location = 2) uniform mat4 clipFromLocal; // rows x, y and w of the view, z = nearest
