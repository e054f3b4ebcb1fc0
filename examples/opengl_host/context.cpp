// SPDX-License-Identifier: MIT
#include "context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <stdexcept>
#include <string>

bool makeContext()
{
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        return false;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

void checkErrors(const char* what)
{
    if (const GLenum error = glGetError())
        throw std::runtime_error(std::string(what) + ": OpenGL error " + std::to_string(error));
}
