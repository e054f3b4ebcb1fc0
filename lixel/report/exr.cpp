// SPDX-License-Identifier: MIT
#include "lixel/report/exr.h"

#include "lixel/base/assert.h"
#include "lixel/report/write_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace lixel {
namespace {

// OpenEXR seeks back to fill in the line table, so the whole file is made in memory.
class MemoryStream : public Imf::OStream
{
public:
    MemoryStream() : Imf::OStream("memory") {}

    void write(const char bytes[], int count) override
    {
        const std::size_t end = position_ + std::size_t(count);
        if (bytes_.size() < end) bytes_.resize(end);
        std::memcpy(bytes_.data() + position_, bytes, std::size_t(count));
        position_ = end;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = std::size_t(position); }

    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    std::size_t position_ = 0;
};

// The rows of a channel in the other order, as the file has them.
std::vector<float> turned(std::span<const float> values, int width, int height)
{
    std::vector<float> rows(values.begin(), values.end());
    for (int y = 0; y < height / 2; ++y) {
        const auto row = [&](int index) { return rows.begin() + std::ptrdiff_t(index) * width; };
        std::swap_ranges(row(y), row(y + 1), row(height - 1 - y));
    }
    return rows;
}

Imf::Slice sliceOf(std::vector<float>& rows, int width)
{
    return {Imf::FLOAT, reinterpret_cast<char*>(rows.data()), sizeof(float), sizeof(float) * std::size_t(width)};
}

} // namespace

void writeExr(const std::filesystem::path& path, int width, int height, std::span<const ExrChannel> channels,
              Vec3d originWorld)
{
    LX_ASSERT(width > 0 && height > 0 && !channels.empty());
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.insert("originWorld", Imf::V3dAttribute({originWorld.x, originWorld.y, originWorld.z}));

    std::vector<std::vector<float>> rows;
    rows.reserve(channels.size());
    Imf::FrameBuffer frame;
    for (const ExrChannel& channel : channels) {
        LX_ASSERT(channel.values.size() == std::size_t(width) * std::size_t(height));
        rows.push_back(turned(channel.values, width, height));
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
        frame.insert(channel.name, sliceOf(rows.back(), width));
    }

    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(height);
    } // the line table is written when the file ends
    writeFileAtomically(path, stream.bytes());
}

ExrPicture readExr(const std::filesystem::path& path)
try {
    Imf::InputFile file(path.c_str());
    const Imf::Header& header = file.header();
    const Imath::Box2i window = header.dataWindow();
    ExrPicture picture;
    picture.width = window.max.x - window.min.x + 1;
    picture.height = window.max.y - window.min.y + 1;
    if (const auto* origin = header.findTypedAttribute<Imf::V3dAttribute>("originWorld"))
        picture.originWorld = {origin->value().x, origin->value().y, origin->value().z};

    // Slices are addressed from pixel (0, 0), which is the first only where the data window starts there.
    if (window.min != Imath::V2i(0, 0)) throw std::runtime_error("the data window does not start at 0, 0");
    Imf::FrameBuffer frame;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        std::vector<float>& rows = picture.channels[channel.name()];
        rows.resize(std::size_t(picture.width) * std::size_t(picture.height));
        frame.insert(channel.name(), sliceOf(rows, picture.width));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    for (auto& [name, rows] : picture.channels) rows = turned(rows, picture.width, picture.height);
    return picture;
} catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": not an OpenEXR file that can be read: " + error.what());
}

} // namespace lixel
