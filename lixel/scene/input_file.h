// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
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

// A regular file, which must not be empty: the whole of it, or its first `most` bytes.
std::vector<std::byte> readInputFile(const std::string& path, std::size_t most = std::size_t(-1));

// A file that another one names, beside it. Absolute names, and any name where `baseDirectory` is empty, are refused.
std::vector<std::byte> readNeighbour(const std::string& baseDirectory, const std::string& relative,
                                     const std::string& file, const std::string& place);

} // namespace lixel
