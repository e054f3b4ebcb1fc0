// SPDX-License-Identifier: MIT
#include "lixel/scene/image_decode.h"

#include <fmt/format.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#include <stb/stb_image.h>

#include <cstring>
#include <limits>
#include <memory>

namespace lixel {
namespace {

// Deflate cannot make more than 1032 bytes of one (RFC 1951: 258 bytes from two bits); the other formats make fewer.
constexpr std::size_t kMostPixelBytesPerFileByte = 1100;

constexpr std::size_t kMostFileBytes = std::size_t(256) << 20;
constexpr std::size_t kLarge = std::size_t(16) << 20; // whose start is looked at first ...
constexpr std::size_t kStart = std::size_t(1) << 20;  // ... where the size of every image stands

struct FreePixels
{
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

// Its header's width, height and channels, as far as they are in range.
bool readHeader(std::span<const std::byte> bytes, int& width, int& height, int& channels)
{
    const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
    return stbi_info_from_memory(data, int(bytes.size()), &width, &height, &channels) != 0;
}

[[noreturn]] void refuseFormat(const std::string& file, const std::string& place)
{
    refuse(file, place,
           fmt::format("expected a PNG, JPEG, BMP or TGA image of at most {0}x{0} pixels", kMostImageSide));
}

} // namespace

std::vector<std::byte> readImageBytes(InputBytes& bytes, const std::string& file, const std::string& place)
{
    if (bytes.size() > kMostFileBytes) refuse(file, place, "expected an image file of at most 256 MiB");
    int width = 0, height = 0, channels = 0;
    if (bytes.size() > kLarge && !readHeader(bytes.read(0, kStart), width, height, channels)) refuseFormat(file, place);
    return bytes.read(0, bytes.size());
}

Image<Rgba8> decodeImage(std::span<const std::byte> bytes, RowOrder rows, const std::string& file,
                         const std::string& place)
{
    static_assert(sizeof(Rgba8) == 4);
    if (bytes.empty() || bytes.size() > std::size_t(std::numeric_limits<int>::max()))
        refuse(file, place, "expected an image of 1 byte to 2 GiB");
    const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = int(bytes.size());

    // The header is judged before anything is unpacked.
    int width = 0, height = 0, channels = 0;
    if (!readHeader(bytes, width, height, channels)) refuseFormat(file, place);
    if (width < 1 || height < 1 || width > kMostImageSide || height > kMostImageSide)
        refuse(
            file, place,
            fmt::format("expected an image of at most {0}x{0} pixels, found {1}x{2}", kMostImageSide, width, height));
    if (std::size_t(width) * std::size_t(height) / kMostPixelBytesPerFileByte > bytes.size())
        refuse(file, place, fmt::format("expected {}x{} pixels, found only {} bytes", width, height, bytes.size()));

    const std::unique_ptr<stbi_uc, FreePixels> pixels(stbi_load_from_memory(data, size, &width, &height, &channels, 4));
    if (!pixels) {
        const std::string_view reason = stbi_failure_reason(); // empty for some
        refuse(file, place,
               reason.empty() ? "expected a whole image"
                              : fmt::format("expected a whole image: {}", printable(reason)));
    }
    Image<Rgba8> image(width, height);
    const std::size_t rowBytes = std::size_t(width) * 4;
    for (int y = 0; y < height; ++y) {
        const int from = rows == RowOrder::FileFirst ? y : height - 1 - y;
        std::memcpy(static_cast<void*>(&image(0, y)), pixels.get() + std::size_t(from) * rowBytes, rowBytes);
    }
    return image;
}

} // namespace lixel
