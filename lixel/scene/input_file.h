// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Files as they come in: their bytes, or one clear line (InputError) about why there are none.
namespace lixel {

// Throws InputError "file: place: expected"; `place` may be empty.
[[noreturn]] void refuse(std::string_view file, std::string_view place, std::string_view expected);

// Text of a file as it may stand in a message: at most 60 characters, what cannot be printed as '?'.
std::string printable(std::string_view text);

bool isUtf8(std::string_view text);

// The last part of a path without its ending, as valid UTF-8.
std::string sceneName(const std::string& path);

// Bytes of memory or of a file that are read when they are asked for, so that gigabytes behind a wrong start are never read.
class InputBytes
{
public:
    explicit InputBytes(std::span<const std::byte> memory) : size_(memory.size()), memory_(memory) {}
    explicit InputBytes(const std::string& path); // a regular file of 1 byte to 4 GiB

    std::size_t size() const { return size_; }

    // `offset + count` is at most size(). Throws InputError where the file cannot be read.
    std::vector<std::byte> read(std::size_t offset, std::size_t count);

    // The same as text, read up to the first zero byte; one there is refused with `expected`.
    std::string readText(std::size_t offset, std::size_t count, const std::string& file, std::string_view expected);

private:
    void readTo(std::span<std::byte> bytes, std::size_t offset);

    std::size_t size_ = 0;
    std::span<const std::byte> memory_;
    std::string path_;
    std::ifstream stream_;
};

// The whole of a file; of JSON that says how to do something, and not what a scene is, at most 32 MiB. Of any, at most 256 MiB.
std::vector<std::byte> readInputFile(const std::string& path);
std::string readJsonFile(const std::string& path);
std::string readJsonText(InputBytes& bytes, std::size_t offset, std::size_t count, const std::string& file,
                         std::string_view expected, std::size_t mostMiB = 256);

// A file that another one names, beside it. Absolute names, and any name where `baseDirectory` is empty, are refused.
InputBytes openNeighbour(const std::string& baseDirectory, const std::string& relative, const std::string& file,
                         const std::string& place);

} // namespace lixel
