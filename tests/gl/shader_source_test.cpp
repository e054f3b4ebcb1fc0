// SPDX-License-Identifier: MIT
#include "graphics.h"

#include "lixel/gl/device/program.h"
#include "lixel/gl/device/shader_source.h"

#include <epoxy/gl.h>

#include <map>

namespace lixel::test {
namespace {

using namespace gl;

class ShaderSourceTest : public GlTest
{
protected:
    std::map<std::string, std::string, std::less<>> files_;
    ReadShaderFile read_ = [this](std::string_view path) -> std::optional<std::string_view> {
        const auto found = files_.find(path);
        return found == files_.end() ? std::nullopt : std::optional<std::string_view>(found->second);
    };
    std::string errorOf(const std::string& path)
    {
        try {
            compileShader(GL_COMPUTE_SHADER, assembleShader(path, {}, read_));
        } catch (const ShaderError& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(ShaderSourceTest, AnErrorNamesTheFileAndLineItStandsIn)
{
    files_["main.glsl"] =
        "// one\nlayout(local_size_x = 64) in;\n#include \"deep/inner.glsl\"\nvoid main() { wrong(); }\n";
    files_["deep/inner.glsl"] = "int fine;\n\n";
    EXPECT_NE(errorOf("main.glsl").find("main.glsl:4:"), std::string::npos) << errorOf("main.glsl");

    files_["deep/inner.glsl"] = "int fine;\n\nint broken = ;\n";
    EXPECT_NE(errorOf("main.glsl").find("deep/inner.glsl:3:"), std::string::npos) << errorOf("main.glsl");
}

TEST_F(ShaderSourceTest, AMissingFileNamesTheIncludingLine)
{
    files_["main.glsl"] = "\n#include \"gone.glsl\"\n";
    EXPECT_EQ(errorOf("main.glsl"), "main.glsl:2: there is no shader file \"gone.glsl\"");
}

TEST_F(ShaderSourceTest, AFileIncludedTwiceStandsOnceAndCppIncludesAreLeftOut)
{
    files_["main.glsl"] = "#include \"a.h\"\n#include \"b.h\"\nlayout(local_size_x = 64) in;\nvoid main() {}\n";
    files_["a.h"] = "#pragma once\n#include <vector>\nconst int kOnce = 1;\n";
    files_["b.h"] = "#include \"a.h\"\nconst int kTwo = 2 * kOnce;\n";
    EXPECT_EQ(errorOf("main.glsl"), "");
    const ShaderSource source = assembleShader("main.glsl", {}, read_);
    EXPECT_EQ(source.files, (std::vector<std::string>{"main.glsl", "a.h", "b.h"}));
}

TEST_F(ShaderSourceTest, DefinesReachTheShader)
{
    files_["main.glsl"] = "layout(local_size_x = SIZE) in;\nvoid main() {}\n";
    const std::vector<std::string> defines{"SIZE 32"};
    EXPECT_NO_THROW(compileShader(GL_COMPUTE_SHADER, assembleShader("main.glsl", defines, read_)));
    EXPECT_NE(errorOf("main.glsl"), "");
}

TEST(ShaderLog, EveryDriversFormIsUnderstood)
{
    const ShaderSource source{"", {"first.glsl", "second.glsl"}};
    EXPECT_EQ(translateLog("1:12(5): error: x", source), "second.glsl:12: error: x");
    EXPECT_EQ(translateLog("0(7) : error C0000: x", source), "first.glsl:7: error C0000: x");
    EXPECT_EQ(translateLog("ERROR: 1:3: 'x' : undeclared", source), "ERROR: second.glsl:3: 'x' : undeclared");
    EXPECT_EQ(translateLog("9:3(1): error: x", source), "9:3(1): error: x");
    EXPECT_EQ(translateLog("two\n0:1(2): a\n0:2(2): b", source), "two\nfirst.glsl:1: a\nfirst.glsl:2: b");
}

} // namespace
} // namespace lixel::test
