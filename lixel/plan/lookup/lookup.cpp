// SPDX-License-Identifier: MIT
#include "lixel/plan/lookup/lookup.h"

#include <cmath>

namespace lixel {

LookupLayout lookupLayout(const Store& store, const Kernel& kernel)
{
    LookupLayout layout;
    layout.bytesPerLixel = 4 * std::get<DepthStore>(store).depths;
    layout.tapsPerSide = int(std::lround(std::sqrt(double(std::get<PcfKernel>(kernel).taps))));
    layout.reach = 0.5 * layout.tapsPerSide + 0.5; // the outermost tap's lixel may begin up to a lixel beyond the tap
    return layout;
}

} // namespace lixel
