// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/observation_readback.h"

namespace lixel::gl {

void ObservationReadback::push(const SamplePass& pass, const ObservedFrame& frame)
{
    frames_[pushes_++ % frames_.size()] = frame;
    ring_.push(pass.cells(), pass.bytes());
}

void ObservationReadback::pushNothing()
{
    ++pushes_;
    ring_.pushNothing();
}

bool ObservationReadback::take(Observation& out)
{
    const std::span<const std::byte> bytes = ring_.take();
    if (bytes.empty()) return false;
    // Shaders wrote these structs there; mapped memory is aligned far beyond theirs.
    const std::span<const shared::ObservedPoint> cells(reinterpret_cast<const shared::ObservedPoint*>(bytes.data()),
                                                       bytes.size() / sizeof(shared::ObservedPoint));
    listCells(cells, frames_[(pushes_ - 1 - std::uint64_t(ring_.age())) % frames_.size()], out);
    out.ageFrames = ring_.age();
    return true;
}

void ObservationReadback::clear()
{
    ring_.clear();
    pushes_ = 0;
}

} // namespace lixel::gl
