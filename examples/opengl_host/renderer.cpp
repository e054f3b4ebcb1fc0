// SPDX-License-Identifier: MIT
#include "renderer.h"

#include "context.h"
#include "shaders.h"

#include <lixel/gl/caster_shader.h>
#include <lixel/plan/host_matrix.h>
#include <lixel/plan/host_region.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

using namespace lixel;

namespace {

constexpr const char* kVersion = "#version 450 core\n";

void setMatrix(GLuint program, const Mat4d& clipFromLocal)
{
    glProgramUniformMatrix4fv(program, glGetUniformLocation(program, "clipFromLocal"), 1, GL_FALSE,
                              columnsOf(clipFromLocal).data());
}

void setVector(GLuint program, const char* name, Vec3d v)
{
    glProgramUniform3f(program, glGetUniformLocation(program, name), float(v.x), float(v.y), float(v.z));
}

template <typename T>
void upload(GLuint buffer, GLuint binding, const std::vector<T>& values)
{
    static constexpr std::byte kNothing[64] = {}; // a buffer of no bytes cannot be bound
    const bool isEmpty = values.empty();
    glNamedBufferData(buffer, isEmpty ? sizeof(kNothing) : GLsizeiptr(values.size() * sizeof(T)),
                      isEmpty ? static_cast<const void*>(kNothing) : values.data(), GL_STREAM_DRAW);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
}

GLuint makeTarget(std::initializer_list<GLenum> colours, int width, int height)
{
    GLuint framebuffer = 0;
    glCreateFramebuffers(1, &framebuffer);
    const auto attach = [&](GLenum attachment, GLenum format) {
        GLuint renderbuffer = 0;
        glCreateRenderbuffers(1, &renderbuffer);
        glNamedRenderbufferStorage(renderbuffer, format, width, height);
        glNamedFramebufferRenderbuffer(framebuffer, attachment, GL_RENDERBUFFER, renderbuffer);
    };
    std::vector<GLenum> drawn;
    for (const GLenum format : colours) {
        drawn.push_back(GL_COLOR_ATTACHMENT0 + GLenum(drawn.size()));
        attach(drawn.back(), format);
    }
    glNamedFramebufferDrawBuffers(framebuffer, GLsizei(drawn.size()), drawn.data());
    attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
    return framebuffer;
}

// All the state that this renderer draws with; lixel's executor and others may have left anything behind.
void setState(bool isShadowMap)
{
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glClearDepth(0);
    glDisable(GL_CULL_FACE); // triangles have two sides for light
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);         // no bias: the lookup knows the receiver's plane
    if (isShadowMap) glEnable(GL_DEPTH_CLAMP); // casters before the near side still cast
    else glDisable(GL_DEPTH_CLAMP);
}

// Whether casters in the box can darken the region: not where all corners are beyond one of its sides or its far side.
bool reaches(const Mat4d& lightClipFromLocal, const Box& boxLocal)
{
    std::array<int, 5> beyond{};
    for (const Vec3d& corner : boxLocal.corners()) {
        const Vec4d c = lightClipFromLocal * point(corner);
        const double sides[] = {c.w + c.x, c.w - c.x, c.w + c.y, c.w - c.y, c.w - c.z};
        for (std::size_t i = 0; i < 5; ++i) beyond[i] += sides[i] < 0;
    }
    return std::find(beyond.begin(), beyond.end(), 8) == beyond.end();
}

bool reaches(const CasterView& view, const Box& boxLocal)
{
    const auto corners = boxLocal.corners();
    return std::all_of(view.volumeLocal.begin(), view.volumeLocal.end(), [&](const Plane& plane) {
        return std::any_of(corners.begin(), corners.end(),
                           [&](Vec3d corner) { return plane.signedDistance(corner) >= 0; });
    });
}

struct HostLight
{
    float place[4], axis[4], colour[4];
};

HostLight hostLight(const Light& light, Vec3d originWorld)
{
    const bool isAt = light.kind != LightKind::Directional;
    const Vec3d place = isAt ? light.positionWorld - originWorld : -light.directionWorld, axis = light.directionWorld;
    const float cosine = light.kind == LightKind::Spot ? float(std::cos(light.coneAngle / 2)) : -2.0f;
    const float range = std::isfinite(light.range) ? float(light.range) : 0.0f;
    return {{float(place.x), float(place.y), float(place.z), isAt ? 1.0f : 0.0f},
            {float(axis.x), float(axis.y), float(axis.z), cosine},
            {float(light.colour.x), float(light.colour.y), float(light.colour.z), range}};
}

} // namespace

Renderer::Renderer(std::span<const HostMesh> meshes, Vec3d originWorld, int width, int height)
    : originWorld_(originWorld), width_(width), height_(height)
{
    for (const HostMesh& mesh : meshes) {
        GLuint buffer = 0, array = 0;
        glCreateBuffers(1, &buffer);
        glNamedBufferStorage(buffer, GLsizeiptr(mesh.vertices.size() * sizeof(HostVertex)), mesh.vertices.data(), 0);
        glCreateVertexArrays(1, &array);
        glVertexArrayVertexBuffer(array, 0, buffer, 0, sizeof(HostVertex));
        glVertexArrayAttribFormat(array, 0, 3, GL_UNSIGNED_SHORT, GL_TRUE, offsetof(HostVertex, position));
        glVertexArrayAttribIFormat(array, 1, 1, GL_UNSIGNED_SHORT, offsetof(HostVertex, colour));
        glVertexArrayAttribFormat(array, 2, 2, GL_SHORT, GL_TRUE, offsetof(HostVertex, normal));
        for (const GLuint attribute : {0u, 1u, 2u}) {
            glVertexArrayAttribBinding(array, attribute, 0);
            glEnableVertexArrayAttrib(array, attribute);
        }
        meshes_.push_back({translated(mesh.boxWorld, -originWorld), array, int(mesh.vertices.size())});
    }

    const std::string vertex = kVersion + hostShader("vertex.glsl"), scene = vertex + hostShader("scene.vert.glsl");
    const std::string lookup = kVersion + lixelShader("lixel_lookup.glsl");
    sceneProgram_ = makeProgram(scene, lookup + hostShader("scene.frag.glsl"));
    surfaceProgram_ = makeProgram(scene, kVersion + hostShader("surface.frag.glsl"));
    depthProgram_ = makeProgram(vertex + hostShader("depth.vert.glsl"), std::string(kVersion) + "void main() {}\n");
    casterProgram_ =
        makeProgram(kVersion + casterVertexText() + hostShader("vertex.glsl") + hostShader("caster.vert.glsl"),
                    casterFragmentText());

    pictureFramebuffer_ = makeTarget({GL_RGBA8}, width, height);
    surfaceFramebuffer_ = makeTarget({GL_RGBA32F, GL_RGBA16F}, width, height);
    glCreateFramebuffers(1, &atlasFramebuffer_);
    glCreateBuffers(4, tables_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    checkErrors("starting the renderer");
}

void Renderer::drawMesh(const MeshOnDevice& mesh, unsigned program, int instances) const
{
    setVector(program, "meshLowLocal", mesh.boxLocal.min);
    setVector(program, "meshSize", mesh.boxLocal.max - mesh.boxLocal.min);
    glBindVertexArray(mesh.vertexArray);
    glDrawArraysInstanced(GL_TRIANGLES, 0, mesh.vertexCount, instances);
}

void Renderer::drawInto(unsigned framebuffer, const View& view, unsigned program) const
{
    setState(false);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width_, height_);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(program);
    setMatrix(program, toHost(clipFromLocal(view, originWorld_), kHostClip));
    for (const MeshOnDevice& mesh : meshes_) drawMesh(mesh, program, 1);
}

ViewSamples Renderer::see(const View& view) const
{
    glClearColor(0, 0, 0, 0);
    drawInto(surfaceFramebuffer_, view, surfaceProgram_);
    const std::size_t pixels = std::size_t(width_) * std::size_t(height_);
    std::vector<Vec4f> position(pixels), normal(pixels);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, position.data());
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, normal.data());

    ViewSamples seen{width_, height_, originWorld_, {}, {}, {}, {}, {}, {}};
    for (std::size_t i = 0; i < pixels; ++i) {
        const Vec4f p = position[i], n = normal[i];
        if (p.w == 0) continue;
        seen.pixel.push_back({float(int(i) % width_) + 0.5f, float(int(i) / width_) + 0.5f});
        seen.positionLocal.push_back({p.x, p.y, p.z});
        const Vec3d towards = towardsEye(view, originWorld_, {p.x, p.y, p.z});
        const float side = dot(towards, Vec3d{n.x, n.y, n.z}) < 0 ? -1.0f : 1.0f;
        seen.normal.push_back({side * n.x, side * n.y, side * n.z});
        seen.triangle.push_back(kNoTriangle);
    }
    checkErrors("reading back what is seen");
    return seen;
}

unsigned Renderer::drawShadowMaps(const FramePlan& plan)
{
    if (atlas_) glDeleteTextures(1, &atlas_);
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &atlas_);
    glTextureStorage3D(atlas_, 1, GL_DEPTH_COMPONENT32F, std::max(plan.atlas.width, 1), std::max(plan.atlas.height, 1),
                       std::max(plan.layers, 1));
    const GLfloat far = 0;
    glClearTexImage(atlas_, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &far);
    setState(true);
    glBindFramebuffer(GL_FRAMEBUFFER, atlasFramebuffer_);
    glUseProgram(depthProgram_);
    for (const ShadowPlan& light : plan.lights)
        for (const PlannedRegion& planned : light.regions) {
            const HostRegion region = toHost(planned, plan.atlas, kHostClip, kHostOrigin);
            const LixelRectangle& v = region.viewport;
            glNamedFramebufferTextureLayer(atlasFramebuffer_, GL_DEPTH_ATTACHMENT, atlas_, 0, v.layer);
            glViewport(v.x0, v.y0, v.width(), v.height());
            setMatrix(depthProgram_, region.clipFromLocal);
            for (const MeshOnDevice& mesh : meshes_)
                if (reaches(planned.lightClipFromLocal, mesh.boxLocal)) drawMesh(mesh, depthProgram_, 1);
        }
    checkErrors("drawing shadow maps");
    return atlas_;
}

CasterCallback Renderer::casters() const
{
    return {originWorld_, [this](std::span<const CasterView> views) { drawForLixel(views); }, 1};
}

// Framebuffer, viewports and depth are lixel's and stay as they are. Neighbouring views that a mesh reaches are one draw.
void Renderer::drawForLixel(std::span<const CasterView> views) const
{
    glUseProgram(casterProgram_);
    const GLint firstView = glGetUniformLocation(casterProgram_, "lixelFirstView");
    for (const MeshOnDevice& mesh : meshes_)
        for (std::size_t begin = 0; begin < views.size();) {
            std::size_t end = begin;
            while (end < views.size() && reaches(views[end], mesh.boxLocal)) ++end;
            if (end > begin) {
                glProgramUniform1i(casterProgram_, firstView, GLint(views[begin].index));
                drawMesh(mesh, casterProgram_, int(end - begin));
            }
            begin = end + 1;
        }
}

Picture Renderer::draw(const View& view, const FramePlan& plan, std::span<const Light> lights, unsigned atlas)
{
    std::vector<HostLight> own;
    for (const Light& light : lights) own.push_back(hostLight(light, originWorld_));
    upload(tables_[0], 0, plan.regionTable);
    upload(tables_[1], 1, plan.halfSpaceTable);
    upload(tables_[2], 2, plan.lightTable);
    upload(tables_[3], 3, own);
    glBindTextureUnit(0, atlas);
    glProgramUniform1i(sceneProgram_, glGetUniformLocation(sceneProgram_, "tapsPerSide"), plan.lookup.tapsPerSide);
    glClearColor(0.42f, 0.52f, 0.64f, 1);
    drawInto(pictureFramebuffer_, view, sceneProgram_);

    Picture picture{width_, height_, std::vector<std::uint8_t>(3 * std::size_t(width_) * std::size_t(height_))};
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
    checkErrors("drawing the picture");
    return picture;
}
