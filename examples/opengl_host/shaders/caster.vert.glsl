// SPDX-License-Identifier: MIT
// Shadow maps drawn for lixel's executor, behind lixel_caster.glsl: an instance a region.
void main() { lixelCaster(decodedPosition(), vec2(0)); }
