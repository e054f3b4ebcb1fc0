// SPDX-License-Identifier: MIT
#include "lixel/report/png.h"

#include "lixel/report/write_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <png.h>
#include <stdexcept>
#include <vector>

namespace lixel {
namespace {

constexpr std::size_t kPaletteSize = 256;

// The state of libpng's simplified interface.
struct PngImage : png_image
{
    PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
    PngImage(const PngImage&) = delete;
    ~PngImage() { png_image_free(this); }
};

std::uint32_t packed(Rgba8 c)
{
    return std::uint32_t(c.a) << 24 | std::uint32_t(c.r) << 16 | std::uint32_t(c.g) << 8 | std::uint32_t(c.b);
}

// Pixels as the file has them, `channels` bytes each; the bottom row is still the first.
struct Encoding
{
    png_uint_32 format = PNG_FORMAT_RGBA;
    int channels = 4;
    std::vector<std::uint8_t> palette; // RGBA of each colour, when channels is 1
    std::vector<std::uint8_t> pixels;
};

// The colours by their packed value, the most transparent first, which keeps the file's table of alphas short; none
// when there are too many.
std::map<std::uint32_t, std::uint8_t> paletteOf(const Image<Rgba8>& picture)
{
    std::map<std::uint32_t, std::uint8_t> palette;
    std::uint32_t last = packed(picture.data().front()) + 1; // runs of one colour are looked up once
    for (const Rgba8 pixel : picture.data()) {
        if (packed(pixel) == last) continue;
        last = packed(pixel);
        palette.emplace(last, std::uint8_t(0));
        if (palette.size() > kPaletteSize) return {};
    }
    std::uint8_t index = 0;
    for (auto& entry : palette) entry.second = index++;
    return palette;
}

void append(std::vector<std::uint8_t>& bytes, Rgba8 c, int channels)
{
    const std::array<std::uint8_t, 4> all{c.r, c.g, c.b, c.a};
    bytes.insert(bytes.end(), all.begin(), all.begin() + channels);
}

Encoding encodingOf(const Image<Rgba8>& picture)
{
    Encoding encoding;
    const auto palette = paletteOf(picture);
    if (!palette.empty()) {
        encoding.format = PNG_FORMAT_RGBA_COLORMAP;
        encoding.channels = 1;
        for (const auto& [c, _] : palette)
            append(encoding.palette,
                   {std::uint8_t(c >> 16), std::uint8_t(c >> 8), std::uint8_t(c), std::uint8_t(c >> 24)}, 4);
        for (const Rgba8 pixel : picture.data()) encoding.pixels.push_back(palette.at(packed(pixel)));
        return encoding;
    }

    const auto isOpaque = [](Rgba8 pixel) { return pixel.a == 255; };
    if (std::all_of(picture.data().begin(), picture.data().end(), isOpaque)) {
        encoding.format = PNG_FORMAT_RGB;
        encoding.channels = 3;
    }
    for (const Rgba8 pixel : picture.data()) append(encoding.pixels, pixel, encoding.channels);
    return encoding;
}

} // namespace

std::string encodePng(const Image<Rgba8>& picture)
{
    LX_ASSERT(picture.width() > 0 && picture.height() > 0);
    const Encoding encoding = encodingOf(picture);
    PngImage writer;
    writer.width = png_uint_32(picture.width());
    writer.height = png_uint_32(picture.height());
    writer.format = encoding.format;
    writer.colormap_entries = png_uint_32(encoding.palette.size() / 4);

    // The space is an upper bound, so only a lack of memory can fail. A negative stride turns the rows.
    const png_int_32 stride = -png_int_32(picture.width() * encoding.channels);
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(writer), '\0');
    png_alloc_size_t size = bytes.size();
    const int ok = png_image_write_to_memory(&writer, bytes.data(), &size, 0, encoding.pixels.data(), stride,
                                             encoding.palette.data());
    LX_ASSERT(ok != 0);
    bytes.resize(size);
    return bytes;
}

void writePng(const std::filesystem::path& path, const Image<Rgba8>& picture)
{
    writeFileAtomically(path, encodePng(picture));
}

Image<Rgba8> decodePng(std::string_view bytes, std::string_view name)
{
    // Everything comes as 8-bit RGBA, and a negative stride turns the rows.
    PngImage reader;
    const auto check = [&](int ok) {
        if (ok == 0)
            throw std::runtime_error(std::string(name) + ": not a PNG file that can be read: " + reader.message);
    };
    check(png_image_begin_read_from_memory(&reader, bytes.data(), bytes.size()));
    reader.format = PNG_FORMAT_RGBA;
    Image<Rgba8> picture(int(reader.width), int(reader.height));
    check(png_image_finish_read(&reader, nullptr, picture.data().data(), -png_int_32(reader.width * 4), nullptr));
    return picture;
}

Image<Rgba8> readPng(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(path.string() + ": cannot be opened");
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    return decodePng(bytes, path.string());
}

} // namespace lixel
