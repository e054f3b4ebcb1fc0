// SPDX-License-Identifier: MIT
#include "lixel/scene/input_file.h"

#include "lixel/base/assert.h"
#include "lixel/scene/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>

namespace lixel {
namespace {

constexpr std::uintmax_t kMostFileBytes = std::uintmax_t(4) << 30;
constexpr std::size_t kBlockBytes = std::size_t(1) << 20; // of text, read at a time

// Length of the UTF-8 sequence that starts at `text`, 0 where there is none (RFC 3629: no overlong forms, no
// surrogates).
std::size_t sequenceLength(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto isTail = [&](std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first <= 0xdf) return isTail(1) ? 2 : 0;
    if (first >= 0xe0 && first <= 0xef) {
        const bool isOverlong = first == 0xe0 && byte(1) < 0xa0;
        const bool isSurrogate = first == 0xed && byte(1) > 0x9f;
        return isTail(1) && isTail(2) && !isOverlong && !isSurrogate ? 3 : 0;
    }
    if (first >= 0xf0 && first <= 0xf4) {
        const bool isOverlong = first == 0xf0 && byte(1) < 0x90;
        const bool isBeyond = first == 0xf4 && byte(1) > 0x8f;
        return isTail(1) && isTail(2) && isTail(3) && !isOverlong && !isBeyond ? 4 : 0;
    }
    return 0;
}

[[noreturn]] void refuseUnreadable(const std::string& path)
{
    refuse(path, "", fmt::format("cannot be read: {}", errno ? std::strerror(errno) : "unexpected end of file"));
}

} // namespace

void refuse(std::string_view file, std::string_view place, std::string_view expected)
{
    if (place.empty()) throw InputError(fmt::format("{}: {}", file, expected));
    throw InputError(fmt::format("{}: {}: {}", file, place, expected));
}

std::string printable(std::string_view text)
{
    constexpr std::size_t kMost = 60;
    std::string shown;
    while (!text.empty() && shown.size() < kMost) {
        const std::size_t n = sequenceLength(text);
        const bool isControl = n == 1 && (static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7f);
        if (n == 0 || isControl) shown += '?';
        else shown += text.substr(0, n);
        text.remove_prefix(n == 0 ? 1 : n);
    }
    return text.empty() ? shown : shown + "...";
}

bool isUtf8(std::string_view text)
{
    while (!text.empty()) {
        // Eight characters of ASCII at a time.
        std::uint64_t eight = 0;
        while (text.size() >= sizeof eight) {
            std::memcpy(&eight, text.data(), sizeof eight);
            if ((eight & 0x8080808080808080u) != 0) break;
            text.remove_prefix(sizeof eight);
        }
        if (text.empty()) break;
        const std::size_t n = sequenceLength(text);
        if (n == 0) return false;
        text.remove_prefix(n);
    }
    return true;
}

std::string sceneName(const std::string& path) { return printable(std::filesystem::path(path).stem().string()); }

InputBytes::InputBytes(const std::string& path) : path_(path)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) refuse(path, "", "no such file");
    if (error) refuse(path, "", "cannot be read: " + error.message());
    if (std::filesystem::is_directory(status)) refuse(path, "", "is a directory; expected a file");
    if (!std::filesystem::is_regular_file(status)) refuse(path, "", "expected a regular file");

    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) refuse(path, "", "cannot be read: " + error.message());
    if (size == 0) refuse(path, "", "is empty");
    if (size > kMostFileBytes) refuse(path, "", "expected at most 4 GiB");
    size_ = std::size_t(size);

    errno = 0;
    stream_.open(path, std::ios::binary);
    if (!stream_) refuseUnreadable(path);
}

void InputBytes::readTo(std::span<std::byte> bytes, std::size_t offset)
{
    LX_ASSERT(offset <= size_ && bytes.size() <= size_ - offset);
    if (path_.empty()) {
        std::copy_n(memory_.begin() + std::ptrdiff_t(offset), bytes.size(), bytes.begin());
        return;
    }
    errno = 0;
    // The file's bytes are read as what they are; std::byte and char may alias anything.
    if (!stream_.seekg(std::streamoff(offset)) ||
        !stream_.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size())))
        refuseUnreadable(path_);
}

std::vector<std::byte> InputBytes::read(std::size_t offset, std::size_t count)
{
    std::vector<std::byte> bytes(count);
    readTo(bytes, offset);
    return bytes;
}

std::string InputBytes::readText(std::size_t offset, std::size_t count, const std::string& file,
                                 std::string_view expected)
{
    std::string text;
    text.reserve(count); // memory is taken when it is written to
    while (text.size() < count) {
        const std::size_t begin = text.size();
        text.resize(begin + std::min(kBlockBytes, count - begin));
        readTo(std::as_writable_bytes(std::span(text).subspan(begin)), offset + begin);
        if (text.find('\0', begin) != text.npos) refuse(file, "", expected);
    }
    return text;
}

std::vector<std::byte> readInputFile(const std::string& path)
{
    InputBytes bytes(path);
    return bytes.read(0, bytes.size());
}

std::string readJsonFile(const std::string& path)
{
    InputBytes bytes(path);
    return readJsonText(bytes, 0, bytes.size(), path, "expected JSON text, found a zero byte", 32);
}

std::string readJsonText(InputBytes& bytes, std::size_t offset, std::size_t count, const std::string& file,
                         std::string_view expected, std::size_t mostMiB)
{
    if (count > mostMiB << 20) {
        bytes.readText(offset, kBlockBytes, file, expected); // says more, where it is no text at all
        refuse(file, "", fmt::format("expected at most {} MiB of JSON", mostMiB));
    }
    return bytes.readText(offset, count, file, expected);
}

InputBytes openNeighbour(const std::string& baseDirectory, const std::string& relative, const std::string& file,
                         const std::string& place)
{
    const std::string shown = printable(relative);
    for (const char c : relative)
        if (static_cast<unsigned char>(c) < 0x20)
            refuse(file, place, fmt::format("expected a file name, found '{}'", shown));
    if (relative.empty()) refuse(file, place, "expected a file name");
    if (std::filesystem::path(relative).is_absolute() || relative.find("://") != std::string::npos)
        refuse(file, place, fmt::format("expected a file beside this one, found '{}'", shown));
    if (baseDirectory.empty())
        refuse(file, place, fmt::format("needs the file '{}', which is not at hand here", shown));
    try {
        return InputBytes((std::filesystem::path(baseDirectory) / relative).string());
    } catch (const InputError& problem) {
        refuse(file, place, problem.what());
    }
}

} // namespace lixel
