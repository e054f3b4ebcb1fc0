// SPDX-License-Identifier: MIT
#include "graphics.h"

#include <cstdlib>
#include <string>

namespace lixel::test {
namespace {

struct Graphics
{
    std::unique_ptr<gl::Device> device;
    std::string refusal;
    Graphics()
    {
        try {
            device = std::make_unique<gl::Device>();
        } catch (const gl::GraphicsError& error) {
            refusal = error.what();
        }
    }
};

Graphics& theGraphics()
{
    static Graphics graphics;
    return graphics;
}

} // namespace

gl::Device* graphics() { return theGraphics().device.get(); }
const std::string& graphicsRefusal() { return theGraphics().refusal; }

bool requiresGraphics()
{
    const char* value = std::getenv("LIXEL_REQUIRE_GL");
    return value && std::string(value) == "1";
}

} // namespace lixel::test
