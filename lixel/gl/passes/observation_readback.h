// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/gl/device/readback_ring.h"
#include "lixel/gl/passes/sample_pass.h"
#include "lixel/plan/observe.h"

#include <cstdint>
#include <vector>

namespace lixel::gl {

// Observations on their way to the host: the cells in a ReadbackRing, and beside it what they were taken of.
class ObservationReadback
{
public:
    static constexpr const char* kName = "readback";
    explicit ObservationReadback(int age) : ring_(age), frames_(std::size_t(age) + 1) {}

    // The cells of the pass's last run, which `frame` tells of.
    void push(const SamplePass& pass, const ObservedFrame& frame);

    void pushNothing(); // a frame in which nothing was observed

    // What was pushed the ring's age before the last push, into the storage of `out`; false where that was nothing.
    bool take(Observation& out);

    void clear();
    std::uint64_t waits() const { return ring_.waits(); }

private:
    ReadbackRing ring_;
    std::vector<ObservedFrame> frames_;
    std::uint64_t pushes_ = 0;
};

} // namespace lixel::gl
