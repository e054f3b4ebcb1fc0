// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

// Move-only owners of OpenGL objects, made and filled by direct state access. Enumerants are OpenGL's, as plain integers,
// so that no header of ours needs its headers.
namespace lixel::gl {

// OpenGL objects made by this thread so far; a frame that is not the first makes none.
std::uint64_t objectsMade();

// Bytes of the buffers and textures that it has now, as they were asked for: drivers may take more.
std::uint64_t bytesHeld();

namespace detail {
void countObject();

// The name of one object, given back by `Delete`; 0 is none.
template <void (*Delete)(std::uint32_t)>
class Name
{
public:
    Name() = default;
    explicit Name(std::uint32_t name) : name_(name)
    {
        if (name) countObject();
    }
    ~Name() { reset(); }
    Name(Name&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Name& operator=(Name&& other) noexcept
    {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }
    std::uint32_t get() const { return name_; }

private:
    void reset()
    {
        if (name_) Delete(name_);
        name_ = 0;
    }
    std::uint32_t name_ = 0;
};

// Counts in bytesHeld() as long as it lives.
class HeldBytes
{
public:
    HeldBytes() = default;
    explicit HeldBytes(std::uint64_t bytes);
    ~HeldBytes();
    HeldBytes(HeldBytes&& other) noexcept : bytes_(std::exchange(other.bytes_, 0)) {}
    HeldBytes& operator=(HeldBytes&& other) noexcept
    {
        std::swap(bytes_, other.bytes_);
        return *this;
    }

private:
    std::uint64_t bytes_ = 0;
};

void deleteBuffer(std::uint32_t name);
void deleteTexture(std::uint32_t name);
void deleteFramebuffer(std::uint32_t name);
void deleteVertexArray(std::uint32_t name);
void deleteShader(std::uint32_t name);
void deleteProgram(std::uint32_t name);
void deleteQuery(std::uint32_t name);
void deleteSampler(std::uint32_t name);
} // namespace detail

using FramebufferName = detail::Name<detail::deleteFramebuffer>;
using VertexArray = detail::Name<detail::deleteVertexArray>;
using ShaderName = detail::Name<detail::deleteShader>;
using ProgramName = detail::Name<detail::deleteProgram>;
using Query = detail::Name<detail::deleteQuery>;
using Sampler = detail::Name<detail::deleteSampler>;

VertexArray makeVertexArray();
Query makeTimerQuery();
// Compares a depth with the four texels around and filters what comes out: 1 where the texel is not above it.
Sampler makeComparingSampler();

// Bytes on the device. It grows when it must and never shrinks, so that frames of equal sizes make no object.
class Buffer
{
public:
    Buffer() = default;

    // Makes room; contents are lost when it has to grow. Throws GraphicsError where the device has no memory.
    void reserve(std::size_t bytes);

    // Makes room and writes from the start.
    template <typename T>
    void assign(std::span<const T> values)
    {
        reserve(values.size_bytes());
        write(0, values);
    }
    template <typename T>
    void write(std::size_t offset, std::span<const T> values)
    {
        writeBytes(offset, values.data(), values.size_bytes());
    }
    // Waits for the device.
    template <typename T>
    void read(std::size_t offset, std::span<T> values) const
    {
        readBytes(offset, values.data(), values.size_bytes());
    }
    void clear(std::size_t offset, std::size_t bytes); // to zero

    std::size_t capacity() const { return capacity_; }
    std::uint32_t name() const { return name_.get(); }

    // To the shaders' `layout(binding = ...) buffer` or `uniform`. Ranges start at multiples of the device's alignment.
    void bindStorage(int binding, std::size_t offset, std::size_t bytes) const;
    void bindStorage(int binding) const { bindStorage(binding, 0, capacity_); }
    void bindUniform(int binding, std::size_t bytes) const;

private:
    void writeBytes(std::size_t offset, const void* data, std::size_t bytes);
    void readBytes(std::size_t offset, void* data, std::size_t bytes) const;

    detail::Name<detail::deleteBuffer> name_;
    detail::HeldBytes held_;
    std::size_t capacity_ = 0;
};

// Bytes that the device writes and the host reads in place, mapped for good. A fence must say when they are there.
class MappedBuffer
{
public:
    // As Buffer::reserve().
    void reserve(std::size_t bytes);
    std::span<const std::byte> bytes() const { return bytes_; } // all that there is room for
    std::uint32_t name() const { return name_.get(); }

private:
    detail::Name<detail::deleteBuffer> name_; // deleting it unmaps it
    detail::HeldBytes held_;
    std::span<const std::byte> bytes_;
};

// A 2D texture, or a 2D array where `layers` > 0, of immutable size.
class Texture
{
public:
    Texture() = default;
    Texture(std::uint32_t internalFormat, int width, int height, int layers = 0, int levels = 1);

    int width() const { return width_; }
    int height() const { return height_; }
    int layers() const { return layers_; }
    std::uint32_t format() const { return internalFormat_; }
    std::uint32_t name() const { return name_.get(); }

    // Makes it anew when size or format differ; contents are then lost.
    void resize(std::uint32_t internalFormat, int width, int height, int layers = 0);
    void bind(int unit) const;
    void bind(int unit, const Sampler& sampler) const;
    void bindImage(int unit) const; // all layers, for shaders to write

private:
    detail::Name<detail::deleteTexture> name_;
    detail::HeldBytes held_;
    std::uint32_t internalFormat_ = 0;
    int width_ = 0, height_ = 0, layers_ = 0;
};

// Colour attachments in order, and a depth or stencil attachment, or none. Array textures are attached whole: layered.
class Framebuffer
{
public:
    Framebuffer() = default;
    Framebuffer(std::span<const Texture* const> colours, const Texture* depth);
    void bind() const;
    std::uint32_t name() const { return name_.get(); }

private:
    FramebufferName name_;
};

} // namespace lixel::gl
