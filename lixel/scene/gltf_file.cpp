// SPDX-License-Identifier: MIT
#include "lixel/scene/gltf_file.h"

#include "lixel/base/assert.h"
#include "lixel/scene/image_decode.h"
#include "lixel/scene/json_text.h"
#include "lixel/scene/uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace lixel::gltf {
namespace {

constexpr std::size_t kMostUnpackedBytes = std::size_t(2) << 30;
constexpr std::size_t kMostBytesFromNothing = std::size_t(256) << 20;
constexpr std::size_t kLargeView = std::size_t(64) << 20;
constexpr std::size_t kMostViewBytes = std::size_t(4) << 30;
constexpr std::size_t kMostOffset = std::size_t(1) << 40;

// Extensions that change nothing we read, or that we read.
constexpr std::array<std::string_view, 4> kKnownExtensions{"KHR_lights_punctual", "KHR_texture_transform",
                                                           "KHR_mesh_quantization", "KHR_materials_emissive_strength"};

std::uint32_t littleEndian32(std::span<const std::byte> bytes)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
    return value;
}

bool startsWithMagic(std::span<const std::byte> bytes)
{
    return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
}

std::vector<std::byte> dataOf(const JsonAt& uri)
{
    auto bytes = decodeDataUri(uri.text());
    if (!bytes) uri.refuse("expected base64 after 'data:...;base64,'");
    return *std::move(bytes);
}

} // namespace

File::File(InputBytes& bytes, std::string name, std::string baseDirectory)
    : bytes_(bytes), name_(std::move(name)), baseDirectory_(std::move(baseDirectory))
{
    if (bytes_.size() == 0) refuse(name_, "", "is empty");
    const bool isGlb = startsWithMagic(bytes_.read(0, std::min<std::size_t>(bytes_.size(), 4)));
    readJson(isGlb ? splitGlb() : Range{0, bytes_.size()});
    checkVersionAndExtensions();
    loadBuffers();
    loadViews();
}

// Section 4.4: a header of 12 bytes, then chunks; the first is JSON, the second, if any, the binary buffer; others mean nothing.
File::Range File::splitGlb()
{
    constexpr std::uint32_t kJson = 0x4e4f534a, kBin = 0x004e4942;
    if (bytes_.size() < 20) refuse(name_, "GLB header", fmt::format("expected 20 bytes, found {}", bytes_.size()));
    const std::vector<std::byte> header = bytes_.read(0, 12);
    if (const std::uint32_t version = littleEndian32(std::span(header).subspan(4)); version != 2)
        refuse(name_, "GLB header", fmt::format("expected version 2, found {}", version));
    const std::size_t length = littleEndian32(std::span(header).subspan(8));
    if (length > bytes_.size() || length < 20)
        refuse(name_, "GLB header",
               fmt::format("expected {} bytes in all, found {}: is the file truncated?", length, bytes_.size()));

    Range json;
    std::size_t at = 12;
    for (int chunk = 0; chunk < 2 && length - at >= 8; ++chunk) {
        const std::vector<std::byte> head = bytes_.read(at, 8);
        const std::size_t size = littleEndian32(head);
        const std::uint32_t type = littleEndian32(std::span(head).subspan(4));
        at += 8;
        if (size > length - at)
            refuse(name_, fmt::format("GLB chunk {}", chunk),
                   fmt::format("expected {} bytes, found {}", size, length - at));
        if (chunk == 0 && type != kJson) refuse(name_, "GLB chunk 0", "expected JSON");
        if (chunk == 0) json = {at, size};
        if (chunk == 1 && type == kBin) bin_ = {at, size};
        at += size;
    }
    return json;
}

void File::readJson(Range range)
{
    constexpr std::string_view kExpected = "expected glTF: a GLB file, or JSON in UTF-8";
    const std::string all = readJsonText(bytes_, range.offset, range.size, name_, kExpected);
    if (!isUtf8(all)) refuse(name_, "", kExpected);
    json_ = parseJson(all, name_, RepeatedMembers::LastCounts);
    if (!json_.is_object()) refuse(name_, "JSON", "expected an object");
}

void File::checkVersionAndExtensions() const
{
    const auto asset = root().find("asset");
    if (!asset) refuse(name_, "asset", "expected glTF 2.0, found JSON without 'asset'");
    const JsonAt version = asset->require("version");
    if (!version.text().starts_with("2."))
        version.refuse(fmt::format("expected glTF 2.x, found '{}'", printable(version.text())));
    const auto required = root().find("extensionsRequired");
    for (std::size_t i = 0; required && i < required->size(); ++i) {
        const JsonAt extension = (*required)[i];
        if (std::find(kKnownExtensions.begin(), kKnownExtensions.end(), extension.text()) == kKnownExtensions.end())
            extension.refuse(fmt::format("the file needs '{}', which is not supported", printable(extension.text())));
    }
}

void File::loadBuffers()
{
    for (std::size_t i = 0; i < count("buffers"); ++i) {
        const JsonAt buffer = element("buffers", int(i));
        const JsonAt byteLength = buffer.require("byteLength");
        const std::size_t length = byteLength.integer(1, kMostOffset);
        if (const auto uri = buffer.find("uri")) {
            buffers_.push_back(openBuffer(*uri));
            spend(buffers_.back().inUri.size(), buffer);
        } else {
            if (i > 0 || bin_.size == 0) buffer.refuse("expected a 'uri', or to be the binary chunk of a GLB file");
            buffers_.push_back({bin_.size, bin_.offset, {}, {}});
        }
        std::size_t& there = buffers_.back().length;
        if (length > there) byteLength.refuse(fmt::format("expected at most {}, the bytes that are there", there));
        there = length;
    }
}

File::Buffer File::openBuffer(const JsonAt& uri) const
{
    Buffer buffer;
    if (isDataUri(uri.text())) {
        buffer.inUri = dataOf(uri);
        buffer.length = buffer.inUri.size();
    } else {
        buffer.beside = openNeighbour(baseDirectory_, pathOf(uri), name_, uri.place());
        buffer.length = buffer.beside->size();
    }
    return buffer;
}

void File::loadViews()
{
    for (std::size_t i = 0; i < count("bufferViews"); ++i) {
        const JsonAt view = element("bufferViews", int(i));
        const auto buffer = std::size_t(view.require("buffer").index(buffers_.size(), "buffers"));
        const std::size_t there = buffers_[buffer].length;
        const std::size_t offset = view.integerOr("byteOffset", 0, 0, kMostOffset);
        const std::size_t length = view.require("byteLength").integer(1, kMostOffset);
        if (offset + length > there)
            view.refuse(
                fmt::format("expected bytes {} to {} within the {} of its buffer", offset, offset + length, there));
        views_.push_back({buffer, {offset, length}, view.integerOr("byteStride", 0, 4, 252), {}, {}});
    }
}

BufferView File::view(int i) const
{
    const View& view = views_[std::size_t(i)];
    return {view.range.size, view.stride};
}

// At most two reads of a view: of a large one first the part that is asked for, which may be all that is used of it, then all.
std::span<const std::byte> File::bytes(int i, std::size_t offset, std::size_t count)
{
    View& view = views_[std::size_t(i)];
    Buffer& buffer = buffers_[view.buffer];
    LX_ASSERT(offset <= view.range.size && count <= view.range.size - offset);
    if (!buffer.inUri.empty()) return std::span(buffer.inUri).subspan(view.range.offset + offset, count);
    const Range there = view.isRead;
    if (there.size == 0 || offset < there.offset || offset + count > there.offset + there.size) {
        const bool isFirst = there.size == 0;
        view.isRead = isFirst && view.range.size > kLargeView ? Range{offset, count} : Range{0, view.range.size};
        if (view.isRead.size > kMostViewBytes - read_)
            element("bufferViews", i).refuse("expected at most 4 GiB of buffer views");
        read_ += view.isRead.size;
        const std::size_t from = view.range.offset + view.isRead.offset;
        view.bytes = buffer.beside ? buffer.beside->read(from, view.isRead.size)
                                   : bytes_.read(buffer.inGlb + from, view.isRead.size);
    }
    return std::span(view.bytes).subspan(offset - view.isRead.offset, count);
}

std::size_t File::count(const char* array) const
{
    const auto found = root().find(array);
    return found ? found->size() : 0;
}

JsonAt File::element(const char* array, int i) const { return root().require(array)[std::size_t(i)]; }

std::vector<std::byte> File::readImage(const JsonAt& uri) const
{
    if (isDataUri(uri.text())) return dataOf(uri);
    InputBytes bytes = openNeighbour(baseDirectory_, pathOf(uri), name_, uri.place());
    return readImageBytes(bytes, name_, uri.place());
}

std::string File::pathOf(const JsonAt& uri) const
{
    auto path = percentDecoded(uri.text());
    if (!path) uri.refuse("expected two hexadecimal digits after each '%'");
    return *std::move(path);
}

void File::spend(std::size_t bytes, const JsonAt& where)
{
    if (bytes > kMostUnpackedBytes - spent_) where.refuse("expected a scene of at most 2 GiB when unpacked");
    spent_ += bytes;
}

void File::spendOnNothing(std::size_t bytes, const JsonAt& where)
{
    if (bytes > kMostBytesFromNothing - spentOnNothing_)
        where.refuse("expected at most 256 MiB of accessors without bytes");
    spentOnNothing_ += bytes;
}

} // namespace lixel::gltf
