// SPDX-License-Identifier: MIT
#include "graphics.h"
#include "paced_loop.h"
#include "support/random_cases.h"

#include "lixel/gl/device/readback_ring.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <thread>
#include <vector>

namespace lixel::test {
namespace {

using namespace gl;

class ReadbackRingTest : public GlTest
{
};

std::vector<std::uint32_t> words(std::span<const std::byte> bytes)
{
    std::vector<std::uint32_t> out(bytes.size() / sizeof(std::uint32_t));
    if (!out.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
    return out;
}

TEST_F(ReadbackRingTest, DataComesBackAtExactlyItsAgeWhateverItsSize)
{
    for (const int age : {0, 1, 2, 5}) {
        ReadbackRing ring(age);
        Buffer source;
        std::vector<std::vector<std::uint32_t>> pushed;
        Rng rng(7);
        for (int frame = 0; frame < 40; ++frame) {
            std::vector<std::uint32_t>& data = pushed.emplace_back();
            for (int i = rng.integer(1, 300); i > 0; --i) data.push_back(std::uint32_t(rng.bits()));
            source.assign(std::span<const std::uint32_t>(data));
            ring.push(source, data.size() * sizeof(std::uint32_t));
            const std::vector<std::uint32_t> taken = words(ring.take());
            const std::vector<std::uint32_t> nothing;
            EXPECT_EQ(taken, frame < age ? nothing : pushed[std::size_t(frame - age)]) << age << ", frame " << frame;
            EXPECT_EQ(words(ring.take()), taken); // again
        }
        ring.clear();
        EXPECT_TRUE(ring.take().empty());
    }
}

TEST_F(ReadbackRingTest, FramesThatNobodyTakesAreOverwrittenAndTheAgeStays)
{
    ReadbackRing ring(2);
    Buffer source;
    for (std::uint32_t frame = 0; frame < 50; ++frame) {
        source.assign(std::span<const std::uint32_t>(&frame, 1));
        ring.push(source, sizeof(frame));
        if (frame % 7 != 6) continue;
        EXPECT_EQ(words(ring.take()), std::vector<std::uint32_t>{frame - 2});
    }
}

// Six hundred frames of 180 x 180 cells, with a device or a host that is late every few frames.
TEST_F(ReadbackRingTest, APacedLoopNeverWaitsEvenWhenDeviceOrHostIsLate)
{
    const DeviceDelay delay;
    for (const auto& [name, deviceRounds, hostMs] :
         {std::tuple{"even", 0, 0}, std::tuple{"late device", 400, 0}, std::tuple{"late host", 0, 3}}) {
        ReadbackRing ring;
        Buffer source;
        source.reserve(180 * 180 * 48);
        std::uint64_t before = 0;
        runPaced(600, [&](int frame) {
            const std::array<std::uint32_t, 1> word{std::uint32_t(frame)};
            source.write(0, std::span<const std::uint32_t>(word));
            if (deviceRounds && frame % 5 == 0) delay.queue(deviceRounds);
            if (hostMs && frame % 5 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(hostMs));
            ring.push(source, source.capacity());
            const std::span<const std::byte> taken = ring.take();
            if (frame == 3) before = objectsMade();
            if (frame < 2) return;
            EXPECT_EQ(words(taken.first(4)), std::vector<std::uint32_t>{std::uint32_t(frame - 2)});
        });
        EXPECT_EQ(ring.waits(), 0u) << name;
        EXPECT_EQ(objectsMade(), before) << name;
    }
}

TEST_F(ReadbackRingTest, ATakeThatMustWaitIsCountedOnce)
{
    const DeviceDelay delay;
    delay.queue(1); // compiled
    ReadbackRing ring(0);
    Buffer source;
    source.reserve(64);
    for (int frame = 0; frame < 5; ++frame) {
        delay.queue(20000);
        ring.push(source, 64);
        ring.take();
        ring.take();
    }
    EXPECT_EQ(ring.waits(), 5u);
}

} // namespace
} // namespace lixel::test
