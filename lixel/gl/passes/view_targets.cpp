// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/view_targets.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>

namespace lixel::gl {

void ViewTargets::resize(const Device& device, int width, int height)
{
    if (framebuffer.name() && triangles.width() == width && triangles.height() == height) return;
    const int most = device.limits().textureSize;
    if (width > most || height > most)
        throw GraphicsError(
            fmt::format("a picture of {} x {} pixels is asked for, the graphics device takes {} a side; "
                        "use --executor trace",
                        width, height, most));
    triangles.resize(GL_R32UI, width, height);
    baseColour.resize(GL_SRGB8_ALPHA8, width, height);
    normal.resize(GL_RG16, width, height);
    depth.resize(GL_DEPTH_COMPONENT32F, width, height);
    const std::array<const Texture*, 3> colours{&triangles, &baseColour, &normal};
    framebuffer = Framebuffer(colours, &depth);
}

} // namespace lixel::gl
