// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/device.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

namespace lixel::test {

// One context for all tests of the program; nothing, with the reason in graphicsRefusal(), where there is none.
gl::Device* graphics();
const std::string& graphicsRefusal();
bool requiresGraphics(); // LIXEL_REQUIRE_GL=1

// A test on the device: skipped aloud without graphics, failed by errors and high-severity messages of OpenGL.
class GlTest : public ::testing::Test
{
protected:
    void SetUp() override
    {
        if (graphics()) {
            graphics()->makeCurrent();
            graphics()->takeMessages();
            return;
        }
        if (requiresGraphics()) FAIL() << graphicsRefusal();
        GTEST_SKIP() << "no graphics: " << graphicsRefusal();
    }
    void TearDown() override
    {
        if (!graphics()) return;
        graphics()->makeCurrent(); // an executor may have left with its own
        for (const std::string& message : graphics()->takeMessages()) ADD_FAILURE() << "OpenGL: " << message;
    }
    gl::Device& device() { return *graphics(); }
};

// Limits far below any device's, until the end of the scope.
class LowLimits
{
public:
    LowLimits(gl::Device& device, std::int64_t storageBlockBytes) : device_(device), whole_(device.limits())
    {
        gl::DeviceLimits low = whole_;
        low.storageBlockBytes = storageBlockBytes;
        device.setLimits(low);
    }
    ~LowLimits() { device_.setLimits(whole_); }

private:
    gl::Device& device_;
    gl::DeviceLimits whole_;
};

} // namespace lixel::test
