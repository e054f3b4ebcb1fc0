// SPDX-License-Identifier: MIT
#include "graphics.h"

#include "lixel/gl/device/program.h"
#include "lixel/shared/observe.h"
#include "lixel/shared/sdsm.h"
#include "lixel/shared/shading.h"
#include "lixel/shared/shadow_tables.h"
#include "lixel/shared/view_tables.h"
#include "lixel/shared/warp_fill.h"
#include "lixel/shared/warp_raster.h"

#include <epoxy/gl.h>

#include <array>
#include <cstddef>
#include <string>

namespace lixel::test {
namespace {

using namespace gl;

// Structs that C++ and GLSL read from one text: the driver's layout against the compiler's.
class LayoutTest : public GlTest
{
protected:
    // A shader that uses every member of `type` in a block, so that none is left out.
    static ProgramName programWith(const std::string& header, const std::string& type, const std::string& block,
                                   const std::string& use)
    {
        const std::string text = "#include \"" + header + "\"\nlayout(local_size_x = 64) in;\n" + block + " Block { " +
                                 type + " rows[2]; };\n" +
                                 "layout(std430, binding = 1) buffer Out { float result; };\n" + "void main() { " +
                                 type + " row = rows[1]; result = float(" + use + "); }\n";
        const ReadShaderFile read = [&](std::string_view path) {
            return path == "test.glsl" ? std::optional<std::string_view>(text) : readEmbeddedShader(path);
        };
        std::array<ShaderName, 1> shaders{compileShader(GL_COMPUTE_SHADER, assembleShader("test.glsl", {}, read))};
        return linkShaders(shaders, "test");
    }

    static GLint property(const ProgramName& program, GLenum interface, const std::string& variable, GLenum what)
    {
        const GLuint index = glGetProgramResourceIndex(program.get(), interface, variable.c_str());
        EXPECT_NE(index, GL_INVALID_INDEX) << variable;
        GLint value = -1;
        glGetProgramResourceiv(program.get(), interface, index, 1, &what, 1, nullptr, &value);
        return value;
    }

    static void expectOffset(const ProgramName& program, GLenum interface, const std::string& member,
                             std::size_t offset, std::size_t size)
    {
        const std::string first = "rows[0]." + member;
        EXPECT_EQ(property(program, interface, first, GL_OFFSET), GLint(offset)) << member;
        // From one row to the next: a storage block names row 0 alone, a uniform block each of them.
        const GLint stride = interface == GL_UNIFORM
                                 ? property(program, interface, "rows[1]." + member, GL_OFFSET) - GLint(offset)
                                 : property(program, interface, first, GL_TOP_LEVEL_ARRAY_STRIDE);
        EXPECT_EQ(stride, GLint(size)) << member;
    }
};

#define LX_EXPECT_MEMBER(program, interface, type, member)                                                             \
    expectOffset(program, interface, #member, offsetof(type, member), sizeof(type))

constexpr const char* kStorage = "layout(std430, binding = 0) buffer";
constexpr const char* kUniform = "layout(std140, binding = 0) uniform";

TEST_F(LayoutTest, ShadowTablesLieAsInCpp)
{
    const ProgramName region = programWith(
        "lixel/shared/shadow_tables.h", "ShadowRegion", kStorage,
        "row.lightClipFromLocal[0].x + row.lightClipLow[0].x + row.lixelFromNdc.x + row.rectangle.x + row.place.x + "
        "row.plane.x + row.planeDepth.x + row.projection.x + row.warp.kind.x + row.warp.grid.x + row.warp.square.x");
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, lightClipFromLocal);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, lightClipLow);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, lixelFromNdc);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, rectangle);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, place);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, plane);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, planeDepth);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, projection);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, warp.kind);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, warp.grid);
    LX_EXPECT_MEMBER(region, GL_BUFFER_VARIABLE, shared::ShadowRegion, warp.square);
    const std::string matrix = "rows[0].lightClipFromLocal";
    EXPECT_EQ(property(region, GL_BUFFER_VARIABLE, matrix, GL_MATRIX_STRIDE), GLint(sizeof(shared::vec4)));
    EXPECT_EQ(property(region, GL_BUFFER_VARIABLE, matrix, GL_IS_ROW_MAJOR), 0);

    const ProgramName light = programWith("lixel/shared/shadow_tables.h", "ShadowLight", kStorage, "row.regions.x");
    LX_EXPECT_MEMBER(light, GL_BUFFER_VARIABLE, shared::ShadowLight, regions);
}

TEST_F(LayoutTest, ViewTablesLieAsInCpp)
{
    const ProgramName point =
        programWith("lixel/shared/view_tables.h", "ViewPoint", kStorage,
                    "row.positionLocal.x + float(row.pixel) + row.normal.x + float(row.triangle)");
    LX_EXPECT_MEMBER(point, GL_BUFFER_VARIABLE, shared::ViewPoint, positionLocal);
    LX_EXPECT_MEMBER(point, GL_BUFFER_VARIABLE, shared::ViewPoint, pixel);
    LX_EXPECT_MEMBER(point, GL_BUFFER_VARIABLE, shared::ViewPoint, normal);
    LX_EXPECT_MEMBER(point, GL_BUFFER_VARIABLE, shared::ViewPoint, triangle);

    const ProgramName material = programWith("lixel/shared/view_tables.h", "SurfaceMaterial", kStorage,
                                             "row.baseColour.x + row.emission.x + row.alphaCutoff");
    LX_EXPECT_MEMBER(material, GL_BUFFER_VARIABLE, shared::SurfaceMaterial, baseColour);
    LX_EXPECT_MEMBER(material, GL_BUFFER_VARIABLE, shared::SurfaceMaterial, emission);
    LX_EXPECT_MEMBER(material, GL_BUFFER_VARIABLE, shared::SurfaceMaterial, alphaCutoff);

    const ProgramName cell = programWith("lixel/shared/observe.h", "ObservedPoint", kStorage,
                                         "row.point.positionLocal.x + float(row.point.triangle + row.lit + row.facing "
                                         "+ row.atBoundary + row.atDepthJump)");
    LX_EXPECT_MEMBER(cell, GL_BUFFER_VARIABLE, shared::ObservedPoint, point.positionLocal);
    LX_EXPECT_MEMBER(cell, GL_BUFFER_VARIABLE, shared::ObservedPoint, point.triangle);
    LX_EXPECT_MEMBER(cell, GL_BUFFER_VARIABLE, shared::ObservedPoint, lit);
    LX_EXPECT_MEMBER(cell, GL_BUFFER_VARIABLE, shared::ObservedPoint, facing);
    LX_EXPECT_MEMBER(cell, GL_BUFFER_VARIABLE, shared::ObservedPoint, atBoundary);
    LX_EXPECT_MEMBER(cell, GL_BUFFER_VARIABLE, shared::ObservedPoint, atDepthJump);

    const ProgramName rays = programWith("lixel/shared/view_tables.h", "ViewRays", kUniform,
                                         "row.rayOrigin[2].x + row.rayDirection[2].x + row.clipW.x + row.eyeLocal.x");
    expectOffset(rays, GL_UNIFORM, "rayOrigin[0]", offsetof(shared::ViewRays, rayOrigin), sizeof(shared::ViewRays));
    expectOffset(rays, GL_UNIFORM, "rayDirection[0]", offsetof(shared::ViewRays, rayDirection),
                 sizeof(shared::ViewRays));
    LX_EXPECT_MEMBER(rays, GL_UNIFORM, shared::ViewRays, clipW);
    LX_EXPECT_MEMBER(rays, GL_UNIFORM, shared::ViewRays, eyeLocal);
    EXPECT_EQ(property(rays, GL_UNIFORM, "rows[0].rayOrigin[0]", GL_ARRAY_STRIDE), GLint(sizeof(shared::dvec4)));
}

TEST_F(LayoutTest, SdsmTablesLieAsInCpp)
{
    const ProgramName setup = programWith("lixel/shared/sdsm.h", "SdsmSetup", kUniform,
                                          "row.light.colour.x + row.viewDepth.x + row.lightX.x + row.lightY.x + "
                                          "row.lightDepth.x + row.regions.x + row.options.x");
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::SdsmSetup, light.colour);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::SdsmSetup, viewDepth);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::SdsmSetup, lightX);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::SdsmSetup, lightY);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::SdsmSetup, lightDepth);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::SdsmSetup, regions);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::SdsmSetup, options);

    const ProgramName casters =
        programWith("lixel/shared/sdsm.h", "SdsmCasters", kStorage, "row.onPlane.x + row.depth.x");
    LX_EXPECT_MEMBER(casters, GL_BUFFER_VARIABLE, shared::SdsmCasters, onPlane);
    LX_EXPECT_MEMBER(casters, GL_BUFFER_VARIABLE, shared::SdsmCasters, depth);
}

TEST_F(LayoutTest, WarpRasterTablesLieAsInCpp)
{
    const ProgramName setup =
        programWith("lixel/shared/warp_raster.h", "WarpRasterSetup", kUniform, "row.size.x + row.levels[3].x");
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::WarpRasterSetup, size);
    expectOffset(setup, GL_UNIFORM, "levels[0]", offsetof(shared::WarpRasterSetup, levels),
                 sizeof(shared::WarpRasterSetup));
}

TEST_F(LayoutTest, WarpFillTablesLieAsInCpp)
{
    const ProgramName setup =
        programWith("lixel/shared/warp_fill.h", "WarpFillSetup", kUniform,
                    "row.light.colour.x + row.eye.x + row.picture.x + row.regions.x + row.importance.x");
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::WarpFillSetup, light.colour);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::WarpFillSetup, eye);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::WarpFillSetup, picture);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::WarpFillSetup, regions);
    LX_EXPECT_MEMBER(setup, GL_UNIFORM, shared::WarpFillSetup, importance);
}

TEST_F(LayoutTest, ShadingLightsLieAsInCpp)
{
    const ProgramName light =
        programWith("lixel/shared/shading.h", "ShadingLight", kStorage, "row.place.x + row.axis.x + row.colour.x");
    LX_EXPECT_MEMBER(light, GL_BUFFER_VARIABLE, shared::ShadingLight, place);
    LX_EXPECT_MEMBER(light, GL_BUFFER_VARIABLE, shared::ShadingLight, axis);
    LX_EXPECT_MEMBER(light, GL_BUFFER_VARIABLE, shared::ShadingLight, colour);
}

} // namespace
} // namespace lixel::test
