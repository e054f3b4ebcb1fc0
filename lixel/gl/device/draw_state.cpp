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
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glDepthRange(0, 1);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_FRAMEBUFFER_SRGB); // of textures that are sRGB; others are as they are
    (state.clampsDepth ? glEnable : glDisable)(GL_DEPTH_CLAMP);
}

} // namespace lixel::gl
