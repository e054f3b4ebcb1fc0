// SPDX-License-Identifier: MIT
#pragma once

namespace lixel::gl {

// All fixed state that decides what a draw of ours writes, set as a whole: a host may have left anything behind. Always:
// both sides of triangles, reversed depth in 0..1 (greater is nearer), no blending, stencil or scissor.
struct DrawState
{
    bool clampsDepth = false; // geometry beyond the near and far planes is drawn at them
};
void apply(const DrawState& state);

// Likewise for what turns pixels in memory into texels and back: tightly packed rows, no buffer in between.
void applyPixelTransfer();

} // namespace lixel::gl
