// SPDX-License-Identifier: MIT
#include "lixel/gl/device/device.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <utility>

namespace lixel::gl {
namespace {

constexpr const char* kInstead = "use --executor trace, which needs no graphics";

// A debug storm (one message a draw) must not fill the memory.
constexpr std::size_t kMostMessages = 64;

bool hasName(const char* list, const char* name)
{
    if (!list) return false;
    const std::size_t length = std::strlen(name);
    for (const char* at = std::strstr(list, name); at; at = std::strstr(at + 1, name))
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0')) return true;
    return false;
}

struct EglContext
{
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

// A 4.5 core debug context on this display, without config and surface; nothing where the display cannot.
bool tryDisplay(EGLDisplay display, EglContext& made)
{
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) return false;
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!hasName(extensions, "EGL_KHR_surfaceless_context") || !hasName(extensions, "EGL_KHR_no_config_context"))
        return false;
    if (!eglBindAPI(EGL_OPENGL_API)) return false;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 EGL_TRUE,
                                 EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) return false;
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        eglDestroyContext(display, context);
        return false;
    }
    made = {display, context};
    return true;
}

// The surfaceless platform first, which takes the default driver; then each device that EGL lists, in its order.
bool makeHeadless(EglContext& made)
{
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!hasName(client, "EGL_EXT_platform_base")) return false;
    if (hasName(client, "EGL_MESA_platform_surfaceless") &&
        tryDisplay(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr), made))
        return true;
    if (!hasName(client, "EGL_EXT_platform_device") ||
        !(hasName(client, "EGL_EXT_device_enumeration") || hasName(client, "EGL_EXT_device_base")))
        return false;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count)) return false;
    for (EGLint i = 0; i < count; ++i)
        if (tryDisplay(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr), made))
            return true;
    return false;
}

std::int64_t limit(GLenum name)
{
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return value;
}

DeviceLimits queryLimits()
{
    DeviceLimits limits;
    limits.textureSize = int(limit(GL_MAX_TEXTURE_SIZE));
    limits.textureLayers = int(limit(GL_MAX_ARRAY_TEXTURE_LAYERS));
    limits.viewports = int(limit(GL_MAX_VIEWPORTS));
    limits.storageBlockBytes = limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
    limits.storageAlignment = limit(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT);
    limits.uniformBlockBytes = limit(GL_MAX_UNIFORM_BLOCK_SIZE);
    GLint groups = 0;
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &groups);
    limits.workGroupsX = groups;
    return limits;
}

const char* errorName(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    default: return "an unnamed OpenGL error";
    }
}

// What shader compilers say comes back as ShaderError.
void GLAPIENTRY collectMessage(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                               const void* user)
{
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
    auto& messages = *static_cast<std::vector<std::string>*>(const_cast<void*>(user));
    if (messages.size() < kMostMessages) messages.emplace_back(text, std::size_t(length));
}

} // namespace

struct Device::State
{
    EglContext egl;
    std::string renderer;
    bool isSoftware = false;
    DeviceLimits limits;
    std::vector<std::string> messages;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    // The display stays initialised: EGL has one a platform and process, and other devices may stand on it.
    ~State()
    {
        if (egl.context == EGL_NO_CONTEXT) return;
        if (eglGetCurrentContext() == egl.context)
            eglMakeCurrent(egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(egl.display, egl.context);
    }

    void requireVersion() const
    {
        const char* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
        if (!version) throw GraphicsError("no OpenGL context is current on this thread");
        if (epoxy_gl_version() < 45 || !epoxy_has_gl_extension("GL_ARB_shader_viewport_layer_array"))
            throw GraphicsError(
                fmt::format("OpenGL 4.5 core with GL_ARB_shader_viewport_layer_array is needed, the driver "
                            "has {}; {}",
                            version, kInstead));
    }
};

Device::Device(Context context) : state_(std::make_unique<State>())
{
    if (context == Context::Headless && !makeHeadless(state_->egl))
        throw GraphicsError(
            fmt::format("no OpenGL 4.5 core context could be made through EGL without a display; {}", kInstead));
    state_->requireVersion();
    state_->renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    state_->isSoftware = state_->renderer.find("llvmpipe") != std::string::npos ||
                         state_->renderer.find("softpipe") != std::string::npos ||
                         state_->renderer.find("SwiftShader") != std::string::npos;
    state_->limits = queryLimits();
    if (context == Context::Headless) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(collectMessage, &state_->messages);
    }
}

Device::~Device() = default;
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;

void Device::makeCurrent() const
{
    const EglContext& egl = state_->egl;
    if (egl.context == EGL_NO_CONTEXT || eglGetCurrentContext() == egl.context) return;
    if (!eglMakeCurrent(egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl.context))
        throw GraphicsError("the OpenGL context could not be made current");
}

const std::string& Device::renderer() const { return state_->renderer; }
bool Device::isSoftware() const { return state_->isSoftware; }
const DeviceLimits& Device::limits() const { return state_->limits; }
void Device::setLimits(const DeviceLimits& lower) { state_->limits = lower; }

std::vector<std::string> Device::takeMessages() const
{
    // Where debug output is on, the flags repeat what was told; they are cleared in any case.
    const bool isOurs = state_->egl.context != EGL_NO_CONTEXT;
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
        if (!isOurs && state_->messages.size() < kMostMessages) state_->messages.emplace_back(errorName(error));
    return std::exchange(state_->messages, {});
}

void Device::throwOnMessages(const char* during) const
{
    const std::vector<std::string> messages = takeMessages();
    if (!messages.empty()) throw GraphicsError(fmt::format("OpenGL failed during {}: {}", during, messages.front()));
}

} // namespace lixel::gl
