// SPDX-License-Identifier: MIT
#pragma once

namespace lixel::gl {

// All fixed state that decides what a draw of ours writes, set as a whole: a host may have left anything behind. Always:
// both sides of triangles, reversed depth in 0..1 (greater is nearer), no blending or scissor.
struct DrawState
{
    bool clampsDepth = false; // geometry beyond the near and far planes is drawn at them
    // Nothing is drawn but counted in the stencil, modulo 256 and whatever its depth: 1 for each side that faces away and -1 for each
    // that faces the viewer.
    bool counts = false;
};
void apply(const DrawState& state);

// Likewise for what turns pixels in memory into texels and back: tightly packed rows, no buffer in between.
void applyPixelTransfer();

} // namespace lixel::gl
