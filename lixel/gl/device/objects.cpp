// SPDX-License-Identifier: MIT
#include "lixel/gl/device/objects.h"

#include "lixel/base/assert.h"
#include "lixel/gl/device/device.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace lixel::gl {
namespace {
thread_local std::uint64_t made = 0, held = 0;
}

std::uint64_t objectsMade() { return made; }
std::uint64_t bytesHeld() { return held; }

namespace detail {
void countObject() { ++made; }
HeldBytes::HeldBytes(std::uint64_t bytes) : bytes_(bytes) { held += bytes; }
HeldBytes::~HeldBytes() { held -= bytes_; }
void deleteBuffer(std::uint32_t name) { glDeleteBuffers(1, &name); }
void deleteTexture(std::uint32_t name) { glDeleteTextures(1, &name); }
void deleteFramebuffer(std::uint32_t name) { glDeleteFramebuffers(1, &name); }
void deleteVertexArray(std::uint32_t name) { glDeleteVertexArrays(1, &name); }
void deleteShader(std::uint32_t name) { glDeleteShader(name); }
void deleteProgram(std::uint32_t name) { glDeleteProgram(name); }
void deleteQuery(std::uint32_t name) { glDeleteQueries(1, &name); }
void deleteSampler(std::uint32_t name) { glDeleteSamplers(1, &name); }
} // namespace detail

VertexArray makeVertexArray()
{
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return VertexArray(name);
}

Query makeTimerQuery()
{
    GLuint name = 0;
    glCreateQueries(GL_TIME_ELAPSED, 1, &name);
    return Query(name);
}

Sampler makeComparingSampler()
{
    GLuint name = 0;
    glCreateSamplers(1, &name);
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    return Sampler(name);
}

namespace {

// OpenGL knows no empty buffer.
std::size_t leastRoom(std::size_t bytes) { return std::max<std::size_t>(bytes, 16); }

detail::Name<detail::deleteBuffer> makeBuffer(std::size_t bytes, GLbitfield flags)
{
    GLuint name = 0;
    glCreateBuffers(1, &name);
    detail::Name<detail::deleteBuffer> buffer(name);
    glNamedBufferStorage(name, GLsizeiptr(bytes), nullptr, flags);
    GLint64 got = 0;
    glGetNamedBufferParameteri64v(name, GL_BUFFER_SIZE, &got);
    if (got != GLint64(bytes))
        throw GraphicsError(fmt::format("the graphics device has no room for a buffer of {} bytes", bytes));
    return buffer;
}

} // namespace

void Buffer::reserve(std::size_t bytes)
{
    if (name_.get() && bytes <= capacity_) return;
    name_ = makeBuffer(leastRoom(bytes), GL_DYNAMIC_STORAGE_BIT);
    capacity_ = leastRoom(bytes);
    held_ = detail::HeldBytes(capacity_);
}

void MappedBuffer::reserve(std::size_t bytes)
{
    if (name_.get() && bytes <= bytes_.size()) return;
    const std::size_t capacity = leastRoom(bytes);
    constexpr GLbitfield access = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    bytes_ = {};
    name_ = makeBuffer(capacity, access | GL_CLIENT_STORAGE_BIT);
    const void* mapped = glMapNamedBufferRange(name_.get(), 0, GLsizeiptr(capacity), access);
    if (!mapped) throw GraphicsError("the graphics driver shows the host no memory of a buffer");
    bytes_ = {static_cast<const std::byte*>(mapped), capacity};
    held_ = detail::HeldBytes(capacity);
}

namespace {

// Of a texture with storage, all its levels.
std::uint64_t bytesOf(GLuint texture, int levels)
{
    constexpr GLenum kSizes[] = {GL_TEXTURE_RED_SIZE,   GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                                 GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE};
    const auto parameter = [&](int level, GLenum name) {
        GLint value = 0;
        glGetTextureLevelParameteriv(texture, level, name, &value);
        return std::uint64_t(value);
    };
    std::uint64_t bytes = 0, bits = 0;
    for (const GLenum size : kSizes) bits += parameter(0, size);
    for (int level = 0; level < levels; ++level)
        bytes += parameter(level, GL_TEXTURE_WIDTH) * parameter(level, GL_TEXTURE_HEIGHT) *
                 parameter(level, GL_TEXTURE_DEPTH) * bits / 8;
    return bytes;
}

} // namespace

void Buffer::clear(std::size_t offset, std::size_t bytes)
{
    if (bytes == 0) return;
    const std::uint32_t zero = 0;
    glClearNamedBufferSubData(name(), GL_R32UI, GLintptr(offset), GLsizeiptr(bytes), GL_RED_INTEGER, GL_UNSIGNED_INT,
                              &zero);
}

void Buffer::bindStorage(int binding, std::size_t offset, std::size_t bytes) const
{
    LX_ASSERT(offset + bytes <= capacity_ && bytes > 0);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, GLuint(binding), name(), GLintptr(offset), GLsizeiptr(bytes));
}

void Buffer::bindUniform(int binding, std::size_t bytes) const
{
    LX_ASSERT(bytes <= capacity_ && bytes > 0);
    glBindBufferRange(GL_UNIFORM_BUFFER, GLuint(binding), name(), 0, GLsizeiptr(bytes));
}

void Buffer::writeBytes(std::size_t offset, const void* data, std::size_t bytes)
{
    LX_ASSERT(offset + bytes <= capacity_);
    if (bytes > 0) glNamedBufferSubData(name(), GLintptr(offset), GLsizeiptr(bytes), data);
}

void Buffer::readBytes(std::size_t offset, void* data, std::size_t bytes) const
{
    LX_ASSERT(offset + bytes <= capacity_);
    if (bytes > 0) glGetNamedBufferSubData(name(), GLintptr(offset), GLsizeiptr(bytes), data);
}

Texture::Texture(std::uint32_t internalFormat, int width, int height, int layers, int levels)
    : internalFormat_(internalFormat), width_(width), height_(height), layers_(layers)
{
    GLuint name = 0;
    glCreateTextures(layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &name);
    name_ = detail::Name<detail::deleteTexture>(name);
    if (layers > 0) glTextureStorage3D(name, levels, internalFormat, width, height, layers);
    else glTextureStorage2D(name, levels, internalFormat, width, height);
    held_ = detail::HeldBytes(bytesOf(name, levels));
    // Maps and images are read with texelFetch.
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void Texture::resize(std::uint32_t internalFormat, int width, int height, int layers)
{
    if (name_.get() && internalFormat == internalFormat_ && width == width_ && height == height_ && layers == layers_)
        return;
    *this = Texture(internalFormat, width, height, layers);
}

void Texture::bind(int unit) const
{
    glBindTextureUnit(GLuint(unit), name());
    glBindSampler(GLuint(unit), 0);
}

void Texture::bind(int unit, const Sampler& sampler) const
{
    glBindTextureUnit(GLuint(unit), name());
    glBindSampler(GLuint(unit), sampler.get());
}

void Texture::bindImage(int unit) const
{
    glBindImageTexture(GLuint(unit), name(), 0, GL_TRUE, 0, GL_WRITE_ONLY, internalFormat_);
}

Framebuffer::Framebuffer(std::span<const Texture* const> colours, const Texture* depth)
{
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    name_ = FramebufferName(name);
    std::array<GLenum, 8> attachments{};
    LX_ASSERT(colours.size() <= attachments.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        attachments[i] = GLenum(GL_COLOR_ATTACHMENT0 + i);
        glNamedFramebufferTexture(name, attachments[i], colours[i]->name(), 0);
    }
    glNamedFramebufferDrawBuffers(name, GLsizei(colours.size()), attachments.data());
    if (depth) {
        const bool isStencil = depth->format() == GL_STENCIL_INDEX8;
        glNamedFramebufferTexture(name, isStencil ? GL_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, depth->name(), 0);
    }
    if (glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw GraphicsError("the driver cannot draw into the textures of a pass");
}

void Framebuffer::bind() const { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name()); }

} // namespace lixel::gl
