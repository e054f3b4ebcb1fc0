// SPDX-License-Identifier: MIT
#include "lixel/plan/lookup/lookup_words.h"

#include <array>

#include <fmt/format.h>

namespace lixel {
namespace {

using Answer = std::optional<std::string>;

constexpr std::array<std::string_view, 4> kSelections{"max", "min", "minmax", "sorted"};
constexpr std::array<std::string_view, 4> kMoments{"vsm", "evsm2", "evsm4", "msm"};

template <typename Slot, typename Value>
std::string setOnce(Slot& slot, const Value& value, std::string_view kind)
{
    if (slot) return fmt::format("more than one {}", kind);
    slot = value;
    return "";
}

DepthSelection standardSelection(int depths)
{
    if (depths <= 2) return DepthSelection::Max;
    return depths == 3 ? DepthSelection::MinMax : DepthSelection::Sorted;
}

// What the number of depths goes with; empty, or what it does not.
std::string checkDepths(const DepthStore& store)
{
    const bool isExtreme = store.selection == DepthSelection::Max || store.selection == DepthSelection::Min;
    if (store.depths == 2 && !isExtreme) return "depths(2) takes max or min";
    if (store.depths == 3 && store.selection != DepthSelection::MinMax) return "depths(3) takes minmax";
    if (store.depths > 3 && store.selection != DepthSelection::Sorted) return "depths(4) to depths(8) take sorted";
    if (store.depths > 4 && store.bits == 32) return "more than four depths take 16 bits each";
    if (store.depths < 4 && store.bits == 16) return "up to three depths take 32 bits each";
    return "";
}

Answer takeDepths(const Word& word, LookupParts& parts)
{
    if (word.name != "depths") return std::nullopt;
    Arguments arguments(word);
    DepthStore store;
    const auto count = arguments.take("n", true);
    if (!count && !word.arguments.empty()) return "depths(n) takes n = 1 to 8";
    const auto n = count ? readInteger(*count) : std::optional(1);
    if (!n || *n < 1 || *n > 8) return "depths(n) takes n = 1 to 8";
    store.depths = *n;
    store.selection = standardSelection(*n);
    store.bits = *n > 4 ? 16 : 32;
    bool isGiven = false;
    for (std::size_t i = 0; i < kSelections.size(); ++i) {
        if (!arguments.takeFlag(kSelections[i])) continue;
        if (isGiven) return "depths(n) takes one of max, min, minmax and sorted";
        isGiven = true;
        store.selection = DepthSelection(i);
    }
    if (const auto q = arguments.take("q")) {
        if (*q != "9" && *q != "25") return "depths(n) takes q=9 or q=25 lixels to choose from";
        store.neighbourhood = *q == "9" ? 9 : 25;
        isGiven = true;
    }
    if (const auto bits = arguments.take("bits")) {
        if (*bits != "16" && *bits != "32") return "depths(n) takes bits=16 or bits=32";
        store.bits = *bits == "16" ? 16 : 32;
        isGiven = true;
    }
    if (!arguments.areAllTaken()) return "depths(n) takes max, min, minmax or sorted, q= and bits=";
    if (store.depths == 1 && isGiven) return "depths(1) has no neighbours to choose from";
    if (const std::string wrong = checkDepths(store); !wrong.empty()) return wrong;
    return setOnce(parts.store, Store(store), "store");
}

Answer takeMoments(const Word& word, LookupParts& parts)
{
    for (std::size_t i = 0; i < kMoments.size(); ++i) {
        if (word.name != kMoments[i]) continue;
        Arguments arguments(word);
        MomentStore store{MomentKind(i)};
        if (const auto text = arguments.take("blur", true)) {
            const auto blur = readInteger(*text);
            if (!blur || *blur < 1 || *blur > 15 || *blur % 2 == 0)
                return fmt::format("{}(blur) takes an odd blur = 1 to 15 lixels", word.name);
            store.blur = *blur;
        }
        if (!arguments.areAllTaken()) return fmt::format("{} takes blur=", word.name);
        return setOnce(parts.store, Store(store), "store");
    }
    return std::nullopt;
}

Answer takePcf(const Word& word, LookupParts& parts)
{
    if (word.name != "pcf") return std::nullopt;
    Arguments arguments(word);
    const bool isRotated = arguments.takeFlag("rotated"), isJittered = arguments.takeFlag("jittered");
    const bool hasRest = !arguments.areAllTaken();
    const auto text = arguments.take("k", true);
    const auto k = text ? readInteger(*text) : std::optional(9);
    if (!k || (hasRest && !text) || (*k != 1 && *k != 4 && *k != 9 && *k != 16 && *k != 25))
        return "pcf(k) takes k = 1, 4, 9, 16 or 25";
    if ((isRotated && isJittered) || !arguments.areAllTaken()) return "pcf(k) takes rotated or jittered";
    const PcfGrid grid = isRotated ? PcfGrid::Rotated : isJittered ? PcfGrid::Jittered : PcfGrid::Regular;
    return setOnce(parts.kernel, Kernel(PcfKernel{*k, grid}), "kernel");
}

} // namespace

std::optional<std::string> takeLookup(const Word& word, LookupParts& parts)
{
    for (const auto reader : {takeDepths, takeMoments, takePcf})
        if (const Answer answer = reader(word, parts)) return *answer;
    if (word.name != "fast-pcf" && word.name != "bilinear" && word.name != "hardware-pcf" && word.name != "dual-plane")
        return std::nullopt;
    if (!word.arguments.empty()) return fmt::format("\"{}\" takes no arguments", word.name);
    if (word.name == "fast-pcf") return setOnce(parts.store, Store(FastPcfStore{}), "store");
    if (word.name == "bilinear") return setOnce(parts.kernel, Kernel(BilinearKernel{}), "kernel");
    if (word.name == "hardware-pcf") return setOnce(parts.kernel, Kernel(HardwarePcfKernel{}), "kernel");
    if (parts.isDualPlane) return "dual-plane twice";
    parts.isDualPlane = true;
    return "";
}

std::string checkLookup(const MapTechnique& technique)
{
    const bool hasMoments = std::holds_alternative<MomentStore>(technique.store);
    const auto* pcf = std::get_if<PcfKernel>(&technique.kernel);
    if (hasMoments && !(pcf && *pcf == PcfKernel{}))
        return "moments are filtered before the lookup (blur=) and take no kernel";
    if (hasMoments && technique.isDualPlane) return "dual-plane goes with depths: moments have no plane";
    const bool isHardware = std::holds_alternative<HardwarePcfKernel>(technique.kernel);
    const auto* depths = std::get_if<DepthStore>(&technique.store);
    if (isHardware && !(depths && depths->depths == 1)) return "hardware-pcf goes with depths(1)";
    if (isHardware && technique.isDualPlane) return "hardware-pcf has no verdict of each lixel for dual-plane";
    if (!pcf && std::holds_alternative<FastPcfStore>(technique.store))
        return "fast-pcf has four lixels of its own and takes pcf(k) only";
    return "";
}

namespace {

std::string name(const DepthStore& store)
{
    if (store.depths == 1) return "depths(1)";
    return fmt::format("depths({},{},q={},bits={})", store.depths, kSelections[std::size_t(store.selection)],
                       store.neighbourhood, store.bits);
}
std::string name(const FastPcfStore&) { return "fast-pcf"; }
std::string name(const MomentStore& store)
{
    return fmt::format("{}(blur={})", kMoments[std::size_t(store.kind)], store.blur);
}
std::string name(const PcfKernel& kernel)
{
    constexpr std::array<std::string_view, 3> kGrids{"", ",rotated", ",jittered"};
    return fmt::format("pcf({}{})", kernel.taps, kGrids[std::size_t(kernel.grid)]);
}
std::string name(const BilinearKernel&) { return "bilinear"; }
std::string name(const HardwarePcfKernel&) { return "hardware-pcf"; }

} // namespace

std::string nameOfLookup(const MapTechnique& technique)
{
    const auto nameOf = [](const auto& choice) { return name(choice); };
    return std::visit(nameOf, technique.store) + "+" + std::visit(nameOf, technique.kernel) +
           (technique.isDualPlane ? "+dual-plane" : "");
}

} // namespace lixel
