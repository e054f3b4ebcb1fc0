// SPDX-License-Identifier: MIT
#include "lixel/scene/load.h"

#include "lixel/scene/input_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace lixel {
namespace {

enum class Format { Gltf, Obj };

constexpr std::size_t kStartBytes = 4096; // that tell what a file is
constexpr std::string_view kBlank = " \t\r\n\xef\xbb\xbf";

std::string_view asText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::optional<Format> formatByEnding(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".gltf" || ending == ".glb") return Format::Gltf;
    if (ending == ".obj") return Format::Obj;
    return std::nullopt;
}

// JSON and GLB by their first character or magic; OBJ by a first word of its own.
std::optional<Format> formatByContent(std::string_view text)
{
    if (text.starts_with("glTF")) return Format::Gltf;
    const std::size_t start = text.find_first_not_of(kBlank);
    if (start == text.npos) return std::nullopt;
    text.remove_prefix(start);
    if (text.starts_with('{')) return Format::Gltf;
    for (const std::string_view word : {"#", "v ", "vt ", "vn ", "f ", "o ", "g ", "s ", "mtllib ", "usemtl "})
        if (text.starts_with(word)) return Format::Obj;
    return std::nullopt;
}

} // namespace

Scene loadScene(const std::string& path)
{
    InputBytes bytes(path);
    auto format = formatByEnding(path);
    if (!format) format = formatByContent(asText(bytes.read(0, std::min(bytes.size(), kStartBytes))));
    if (!format) refuse(path, "", "expected a glTF (.gltf, .glb) or OBJ (.obj) file");
    std::string baseDirectory = std::filesystem::path(path).parent_path().string();
    if (baseDirectory.empty()) baseDirectory = ".";
    return *format == Format::Gltf ? loadGltf(bytes, path, baseDirectory) : loadObj(bytes, path, baseDirectory);
}

Scene loadGltf(std::span<const std::byte> bytes, const std::string& name, const std::string& baseDirectory)
{
    InputBytes input(bytes);
    return loadGltf(input, name, baseDirectory);
}

Scene loadObj(std::string_view text, const std::string& name, const std::string& baseDirectory)
{
    InputBytes input(std::as_bytes(std::span(text)));
    return loadObj(input, name, baseDirectory);
}

} // namespace lixel
