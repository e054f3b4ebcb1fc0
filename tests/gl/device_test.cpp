// SPDX-License-Identifier: MIT
#include "graphics.h"

#include "lixel/gl/device/objects.h"
#include "lixel/gl/device/pass_timer.h"
#include "lixel/gl/device/program.h"

#include <epoxy/gl.h>

#include <array>
#include <vector>

namespace lixel::test {
namespace {

using namespace gl;

class DeviceTest : public GlTest
{
};

TEST_F(DeviceTest, AHeadlessContextIsOpenGl45CoreAndNamesItsRenderer)
{
    GLint major = 0, minor = 0, profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(10 * major + minor, 45);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_FALSE(device().renderer().empty());
    EXPECT_GE(device().limits().viewports, 16);
}

TEST_F(DeviceTest, ErrorsAreCollectedOnceAndThrownOnRequest)
{
    glEnable(0xdead);
    EXPECT_EQ(device().takeMessages().size(), 1u);
    EXPECT_TRUE(device().takeMessages().empty());
    glEnable(0xdead);
    EXPECT_THROW(device().throwOnMessages("a test"), GraphicsError);
    EXPECT_NO_THROW(device().throwOnMessages("a test"));
}

TEST_F(DeviceTest, SeveralContextsLiveBesideEachOtherAndEachFindsItsOwnObjects)
{
    const std::array<std::uint32_t, 4> ours{1, 2, 3, 4};
    Buffer buffer;
    buffer.assign(std::span<const std::uint32_t>(ours));
    {
        Device second;
        EXPECT_FALSE(glIsBuffer(buffer.name()));
        device().makeCurrent();
        EXPECT_TRUE(glIsBuffer(buffer.name()));
        second.makeCurrent();
    }
    device().makeCurrent();
    std::array<std::uint32_t, 4> read{};
    buffer.read(0, std::span<std::uint32_t>(read));
    EXPECT_EQ(read, ours);
}

TEST_F(DeviceTest, AHostsCurrentContextServesAsWellAndItsErrorsAreSeen)
{
    const Device host(Device::Context::Current);
    EXPECT_EQ(host.renderer(), device().renderer());
    EXPECT_TRUE(host.takeMessages().empty());
    glEnable(0xdead);
    device().takeMessages(); // ours has the callback and clears the flag: nothing is told twice
    EXPECT_TRUE(host.takeMessages().empty());
    glEnable(0xdead);
    EXPECT_EQ(host.takeMessages(), std::vector<std::string>{"GL_INVALID_ENUM"});
    device().takeMessages();
}

TEST_F(DeviceTest, ObjectsAreCountedAndABufferThatIsLargeEnoughIsNotMadeAnew)
{
    const std::uint64_t before = objectsMade();
    Buffer buffer;
    buffer.reserve(1024);
    EXPECT_EQ(objectsMade(), before + 1);
    buffer.reserve(512);
    buffer.reserve(1024);
    EXPECT_EQ(objectsMade(), before + 1);
    Buffer moved = std::move(buffer);
    EXPECT_EQ(objectsMade(), before + 1);
    moved.reserve(4096);
    EXPECT_EQ(objectsMade(), before + 2);
}

TEST_F(DeviceTest, ATimerNamesItsPassesInOrderAndIsSilentWhenOff)
{
    PassTimer timer(device());
    {
        PassTimer::Scope unheard(timer, "before");
    }
    timer.start();
    for (const char* name : {"first", "second"}) PassTimer::Scope pass(timer, name);
    const std::vector<PassTimer::Pass> passes = timer.stop();
    ASSERT_EQ(passes.size(), 2u);
    EXPECT_EQ(passes[0].name, "first");
    EXPECT_EQ(passes[1].name, "second");
    EXPECT_GE(passes[0].ms, 0);
    EXPECT_EQ(device().isSoftware(), std::string(timer.clock()) == "glFinish + steady_clock");
}

} // namespace
} // namespace lixel::test
