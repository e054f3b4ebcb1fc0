// SPDX-License-Identifier: MIT
#include "lixel/gl/device/draw_state.h"

#include <epoxy/gl.h>

#include <initializer_list>

namespace lixel::gl {

void apply(const DrawState& state)
{
    for (const GLenum capability : {GL_CULL_FACE, GL_BLEND, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL,
                                    GL_RASTERIZER_DISCARD, GL_PRIMITIVE_RESTART, GL_PRIMITIVE_RESTART_FIXED_INDEX,
                                    GL_COLOR_LOGIC_OP, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK})
        glDisable(capability);
    for (GLenum plane = 0; plane < 8; ++plane) glDisable(GL_CLIP_DISTANCE0 + plane);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    (state.counts ? glDisable : glEnable)(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    const GLboolean draws = state.counts ? GL_FALSE : GL_TRUE;
    glDepthMask(draws);
    glDepthRange(0, 1);
    glColorMask(draws, draws, draws, draws);
    glStencilMask(0xff);
    if (state.counts) {
        glEnable(GL_STENCIL_TEST);
        glFrontFace(GL_CCW);
        glStencilFunc(GL_ALWAYS, 0, 0xff);
        glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
        glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    }
    glEnable(GL_FRAMEBUFFER_SRGB); // of textures that are sRGB; others are as they are
    (state.clampsDepth ? glEnable : glDisable)(GL_DEPTH_CLAMP);
}

void applyPixelTransfer()
{
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (const GLenum parameter :
         {GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_IMAGES,
          GL_PACK_SWAP_BYTES, GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS,
          GL_UNPACK_SKIP_IMAGES, GL_UNPACK_SWAP_BYTES})
        glPixelStorei(parameter, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

} // namespace lixel::gl
