// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/scene.h"

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace lixel {

class InputBytes;

// One clear line about a bad input: the file, the place in it where known, and what was expected.
class InputError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

// Reads a .gltf, .glb or .obj file by its ending, else by its first bytes. Throws InputError; never crashes on any bytes.
Scene loadScene(const std::string& path);

// The two formats. `name` is what messages call the file; `baseDirectory` is where relative files (buffers, images, .mtl) lie;
// empty: such files are refused by name.
Scene loadGltf(InputBytes& bytes, const std::string& name, const std::string& baseDirectory);
Scene loadObj(InputBytes& bytes, const std::string& name, const std::string& baseDirectory);

// The same from memory, for tests and fuzzers.
Scene loadGltf(std::span<const std::byte> bytes, const std::string& name, const std::string& baseDirectory);
Scene loadObj(std::string_view text, const std::string& name, const std::string& baseDirectory);

} // namespace lixel
