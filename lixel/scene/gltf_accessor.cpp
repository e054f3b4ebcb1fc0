// SPDX-License-Identifier: MIT
#include "lixel/scene/gltf_accessor.h"

#include "lixel/scene/input_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace lixel::gltf {
namespace {

constexpr std::size_t kMostOffset = std::size_t(1) << 40;
constexpr std::size_t kMostElements = std::numeric_limits<std::uint32_t>::max();

std::size_t componentBytes(Component component)
{
    switch (component) {
    case Component::Byte:
    case Component::UnsignedByte: return 1;
    case Component::Short:
    case Component::UnsignedShort: return 2;
    case Component::UnsignedInt:
    case Component::Float: return 4;
    }
    return 0;
}

Component readComponent(const JsonAt& place)
{
    const auto component = Component(place.integer(5120, 5126));
    if (componentBytes(component) == 0) place.refuse("expected a component type of glTF: 5120 to 5123, 5125 or 5126");
    return component;
}

std::size_t readComponents(const JsonAt& type)
{
    if (type.text() == "SCALAR") return 1;
    if (type.text() == "VEC2") return 2;
    if (type.text() == "VEC3") return 3;
    if (type.text() == "VEC4") return 4;
    if (type.text() == "MAT4") return 16;
    type.refuse(fmt::format("expected SCALAR, VEC2, VEC3, VEC4 or MAT4 here, found '{}'", printable(type.text())));
}

// Calls `visit` with a value of the C++ type of the component.
template <typename Visit>
void visitComponent(Component component, Visit visit)
{
    switch (component) {
    case Component::Byte: return visit(std::int8_t{});
    case Component::UnsignedByte: return visit(std::uint8_t{});
    case Component::Short: return visit(std::int16_t{});
    case Component::UnsignedShort: return visit(std::uint16_t{});
    case Component::UnsignedInt: return visit(std::uint32_t{});
    case Component::Float: return visit(float{});
    }
}

// Section 3.6.2.2 for normalized integers.
template <typename T>
float asFloat(T value, bool isNormalized)
{
    if (!isNormalized || std::is_same_v<T, float>) return float(value);
    return std::max(float(value) / float(std::numeric_limits<T>::max()), -1.0f);
}

// All elements, or those chosen: `element(k)` is the k-th to be read.
template <typename Out, typename Element, typename Convert>
std::vector<Out> gather(std::span<const std::byte> bytes, std::size_t stride, std::size_t components,
                        Component component, std::size_t count, Element element, Convert convert)
{
    std::vector<Out> out(count * components);
    visitComponent(component, [&](auto sample) {
        using T = decltype(sample);
        Out* to = out.data();
        for (std::size_t k = 0; k < count; ++k) {
            const std::byte* const from = bytes.data() + stride * element(k);
            for (std::size_t c = 0; c < components; ++c) {
                T value;
                std::memcpy(&value, from + c * sizeof(T), sizeof(T));
                *to++ = convert(value);
            }
        }
    });
    return out;
}

constexpr auto kEach = [](std::size_t k) { return k; };

} // namespace

Accessor::Accessor(File& file, const JsonAt& reference) : file_(file), reference_(reference)
{
    const JsonAt accessor = file.element("accessors", reference.index(file.count("accessors"), "accessors"));
    readShape(accessor);
    placeInView(accessor);
    if (const auto sparse = accessor.find("sparse")) overlaySparse(*sparse);
}

void Accessor::readShape(const JsonAt& accessor)
{
    component_ = readComponent(accessor.require("componentType"));
    components_ = readComponents(accessor.require("type"));
    count_ = accessor.require("count").integer(1, kMostElements);
    elementBytes_ = components_ * componentBytes(component_);
    const auto normalized = accessor.find("normalized");
    isNormalized_ = normalized && normalized->boolean();
}

void Accessor::placeInView(const JsonAt& accessor)
{
    const int viewIndex = accessor.indexOr("bufferView", file_.count("bufferViews"), "bufferViews");
    if (viewIndex < 0) {
        file_.spendOnNothing(count_ * elementBytes_, accessor.require("count"));
        own_.assign(count_ * elementBytes_, std::byte(0));
        stride_ = elementBytes_;
        return;
    }
    const BufferView view = file_.view(viewIndex);
    stride_ = view.stride == 0 ? elementBytes_ : view.stride;
    view_ = viewIndex;
    offset_ = accessor.integerOr("byteOffset", 0, 0, kMostOffset);
    size_ = stride_ * (count_ - 1) + elementBytes_; // below 2^41: no overflow
    if (offset_ + size_ > view.size)
        accessor.refuse(
            fmt::format("expected {} elements within the {} bytes of its bufferView, found the last to end at {}",
                        count_, view.size, offset_ + size_));
}

std::span<const std::byte> Accessor::bytes() const
{
    return own_.empty() ? file_.bytes(view_, offset_, size_) : std::span<const std::byte>(own_);
}

// Section 3.6.2.3: some elements are replaced.
void Accessor::overlaySparse(const JsonAt& sparse)
{
    const std::size_t replaced = sparse.require("count").integer(1, count_);
    const JsonAt indices = sparse.require("indices"), values = sparse.require("values");
    const Component indexComponent = readComponent(indices.require("componentType"));
    const std::size_t indexBytes = componentBytes(indexComponent);
    const auto elements = gather<std::uint32_t>(bytesOf(indices, indexBytes, replaced), indexBytes, 1, indexComponent,
                                                replaced, kEach, [](auto value) { return std::uint32_t(value); });
    if (own_.empty()) {
        file_.spend(count_ * elementBytes_, sparse);
        const std::span<const std::byte> base = bytes();
        std::vector<std::byte> all(count_ * elementBytes_);
        for (std::size_t i = 0; i < count_; ++i)
            std::memcpy(all.data() + i * elementBytes_, base.data() + i * stride_, elementBytes_);
        own_ = std::move(all), stride_ = elementBytes_;
    }
    const std::span<const std::byte> replacements = bytesOf(values, elementBytes_, replaced);
    for (std::size_t i = 0; i < replaced; ++i) {
        if (elements[i] >= count_)
            indices.refuse(fmt::format("expected indices below {}, found {}", count_, elements[i]));
        std::memcpy(own_.data() + elements[i] * elementBytes_, replacements.data() + i * elementBytes_, elementBytes_);
    }
}

std::span<const std::byte> Accessor::bytesOf(const JsonAt& part, std::size_t elementBytes, std::size_t count) const
{
    const JsonAt viewReference = part.require("bufferView");
    const int view = viewReference.index(file_.count("bufferViews"), "bufferViews");
    const std::size_t offset = part.integerOr("byteOffset", 0, 0, kMostOffset);
    const std::size_t there = file_.view(view).size;
    if (offset + elementBytes * count > there)
        part.refuse(fmt::format("expected {} elements within the {} bytes of its bufferView", count, there));
    return file_.bytes(view, offset, elementBytes * count);
}

const Accessor& Accessor::expect(std::size_t components) const
{
    if (components_ != components)
        reference_.refuse(fmt::format("expected an accessor of {} components, found {}", components, components_));
    return *this;
}

std::vector<float> Accessor::floats() const { return floats({}); }

std::vector<float> Accessor::floats(std::span<const std::uint32_t> elements) const
{
    const std::size_t count = elements.empty() ? count_ : elements.size();
    file_.spend(count * components_ * sizeof(float), reference_);
    const auto convert = [this](auto value) { return asFloat(value, isNormalized_); };
    std::vector<float> all = elements.empty()
                                 ? gather<float>(bytes(), stride_, components_, component_, count, kEach, convert)
                                 : gather<float>(
                                       bytes(), stride_, components_, component_, count,
                                       [&](std::size_t k) { return std::size_t(elements[k]); }, convert);
    const auto wrong =
        std::find_if(all.begin(), all.end(), [](float value) { return !(std::abs(value) <= float(kMostCoordinate)); });
    if (wrong != all.end()) {
        const std::size_t k = std::size_t(wrong - all.begin()) / components_;
        reference_.refuse(fmt::format("expected finite numbers up to 1e30, found {} in element {}", *wrong,
                                      elements.empty() ? k : elements[k]));
    }
    return all;
}

std::vector<std::uint32_t> Accessor::integers() const { return integers({}); }

std::vector<std::uint32_t> Accessor::integers(std::span<const std::uint32_t> elements) const
{
    const bool isUnsigned = component_ == Component::UnsignedByte || component_ == Component::UnsignedShort ||
                            component_ == Component::UnsignedInt;
    if (!isUnsigned) reference_.refuse("expected an accessor of unsigned integers");
    const std::size_t count = elements.empty() ? count_ : elements.size();
    file_.spend(count * components_ * sizeof(std::uint32_t), reference_);
    const auto convert = [](auto value) { return std::uint32_t(value); };
    if (elements.empty())
        return gather<std::uint32_t>(bytes(), stride_, components_, component_, count, kEach, convert);
    return gather<std::uint32_t>(
        bytes(), stride_, components_, component_, count, [&](std::size_t k) { return std::size_t(elements[k]); },
        convert);
}

} // namespace lixel::gltf
