// SPDX-License-Identifier: MIT
#include "lixel/plan/lookup/lookup.h"

#include <cmath>

namespace lixel {
namespace {

constexpr int kMapBytes = 4, kWordBytes = 4, kChannelBytes = 4, kGradientBytes = 4;

void take(const DepthStore& store, LookupLayout& layout)
{
    layout.how.depths = store.depths;
    if (store.depths == 1) return;
    layout.how.selection = int(store.selection);
    layout.how.around = store.neighbourhood == 25 ? 2 : 1;
    layout.reach += layout.how.around;
    layout.how.store = store.bits == 16 ? shared::LX_STORE_DEPTHS16 : shared::LX_STORE_DEPTHS32;
    layout.preparedWords = store.depths == 2 ? 2 : 4;
    layout.hasMoreWords = store.depths > 6;
}

void take(const FastPcfStore&, LookupLayout& layout)
{
    layout.how.store = shared::LX_STORE_DEPTHS8;
    layout.how.depths = 4;
    layout.preparedWords = 1;
    layout.reach += 0.5;
}

void take(const MomentStore& store, LookupLayout& layout)
{
    constexpr int kStores[] = {shared::LX_STORE_VSM, shared::LX_STORE_EVSM2, shared::LX_STORE_EVSM4,
                               shared::LX_STORE_MSM};
    layout.how.store = kStores[std::size_t(store.kind)];
    layout.how.blur = store.blur;
    layout.momentChannels = store.kind == MomentKind::Vsm || store.kind == MomentKind::Evsm2 ? 2 : 4;
    layout.reach += 0.5 * store.blur;
}

void take(const PcfKernel& kernel, LookupLayout& layout)
{
    constexpr int kKernels[] = {shared::LX_KERNEL_GRID, shared::LX_KERNEL_ROTATED, shared::LX_KERNEL_JITTERED};
    layout.tapsPerSide = int(std::lround(std::sqrt(double(kernel.taps))));
    layout.how.kernel = kKernels[std::size_t(kernel.grid)];
    // The outermost tap's lixel may begin up to a lixel beyond the tap.
    const double outermost = 0.5 * (layout.tapsPerSide - 1);
    layout.reach = outermost + 1;
    if (kernel.grid == PcfGrid::Rotated) layout.reach = outermost * std::sqrt(2.0) + 1;
    if (kernel.grid == PcfGrid::Jittered) layout.reach += 0.5;
}

void takeAreas(int kernel, LookupLayout& layout)
{
    layout.tapsPerSide = 2;
    layout.how.kernel = kernel;
    layout.reach = 1.5;
}

void take(const BilinearKernel&, LookupLayout& layout) { takeAreas(shared::LX_KERNEL_BILINEAR, layout); }
void take(const HardwarePcfKernel&, LookupLayout& layout) { takeAreas(shared::LX_KERNEL_HARDWARE, layout); }

// What PreparedMaps makes room for.
void countBytes(LookupLayout& layout)
{
    const int words = kWordBytes * (layout.preparedWords + (layout.hasMoreWords ? 1 : 0));
    const int moments = kChannelBytes * layout.momentChannels;
    const int gradients = layout.hasGradients ? kGradientBytes : 0;
    layout.bytesPerLixel = kMapBytes + words + 2 * moments + gradients;
    layout.bytesReadPerLixel = (words + moments > 0 ? words + moments : kMapBytes) + gradients;
}

} // namespace

LookupLayout lookupLayout(const MapTechnique& technique)
{
    LookupLayout layout;
    std::visit([&](const auto& kernel) { take(kernel, layout); }, technique.kernel);
    std::visit([&](const auto& store) { take(store, layout); }, technique.store);
    layout.how.side = layout.tapsPerSide;
    layout.how.isDualPlane = technique.isDualPlane ? 1 : 0;
    layout.hasGradients = technique.isDualPlane;
    countBytes(layout);
    return layout;
}

LixelFilter filterOf(const LookupLayout& lookup)
{
    if (lookup.momentChannels > 0) return {double(lookup.how.blur)};
    const int more = lookup.how.store == shared::LX_STORE_DEPTHS8 ? 1 : 0;
    return {double(lookup.tapsPerSide + more), lookup.how.kernel == shared::LX_KERNEL_ROTATED};
}

std::string_view whyNoShare(const LookupLayout& lookup)
{
    if (lookup.how.kernel != shared::LX_KERNEL_BILINEAR) return "";
    return "bilinear rounds what it filters and stands for no share of light; hardware-pcf filters as many lixels";
}

} // namespace lixel
