// SPDX-License-Identifier: MIT
#include "picture.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace {

using Bytes = std::vector<std::uint8_t>;

void put32(Bytes& out, std::uint32_t v)
{
    for (const int shift : {24, 16, 8, 0}) out.push_back(std::uint8_t(v >> shift));
}

std::uint32_t crc32(const std::uint8_t* begin, const std::uint8_t* end)
{
    std::uint32_t crc = ~0u;
    for (; begin != end; ++begin) {
        crc ^= *begin;
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

void putChunk(Bytes& out, const char* type, const Bytes& data)
{
    put32(out, std::uint32_t(data.size()));
    const std::size_t from = out.size();
    out.insert(out.end(), type, type + 4);
    out.insert(out.end(), data.begin(), data.end());
    put32(out, crc32(out.data() + from, out.data() + out.size()));
}

// A zlib stream of stored blocks: nothing is compressed.
Bytes stored(const Bytes& raw)
{
    Bytes out{0x78, 0x01};
    std::uint32_t a = 1, b = 0; // Adler-32
    for (const std::uint8_t byte : raw) a = (a + byte) % 65521, b = (b + a) % 65521;
    for (std::size_t at = 0; at < raw.size(); at += 65535) {
        const std::size_t count = std::min<std::size_t>(65535, raw.size() - at);
        const bool isLast = at + count == raw.size();
        out.insert(out.end(), {std::uint8_t(isLast), std::uint8_t(count), std::uint8_t(count >> 8),
                               std::uint8_t(~count), std::uint8_t(~count >> 8)});
        out.insert(out.end(), raw.begin() + std::ptrdiff_t(at), raw.begin() + std::ptrdiff_t(at + count));
    }
    put32(out, b << 16 | a);
    return out;
}

} // namespace

void writePng(const std::string& path, const Picture& picture)
{
    Bytes raw;
    const std::ptrdiff_t row = 3 * std::ptrdiff_t(picture.width);
    for (int y = picture.height - 1; y >= 0; --y) {
        raw.push_back(0); // no filter
        raw.insert(raw.end(), picture.rgb.begin() + y * row, picture.rgb.begin() + (y + 1) * row);
    }
    Bytes header;
    put32(header, std::uint32_t(picture.width));
    put32(header, std::uint32_t(picture.height));
    header.insert(header.end(), {8, 2, 0, 0, 0});

    Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    putChunk(out, "IHDR", header);
    putChunk(out, "IDAT", stored(raw));
    putChunk(out, "IEND", {});
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(out.data()), std::streamsize(out.size()));
    if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

double shareDiffering(const Picture& a, const Picture& b, int most)
{
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        bool differs = false;
        for (std::size_t k = i; k < i + 3; ++k) differs = differs || std::abs(int(a.rgb[k]) - int(b.rgb[k])) > most;
        differing += differs;
    }
    return double(differing) / (double(a.rgb.size()) / 3);
}
