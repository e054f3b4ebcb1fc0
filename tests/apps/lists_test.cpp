// SPDX-License-Identifier: MIT
// The commands that tell what there is.
#include "run_command.h"

#include "lixel/plan/technique.h"
#include "lixel/scene/builtin.h"
#include "lixel/scene/evaluate.h"

#include <gtest/gtest.h>

#include <memory>

namespace lixel::test {
namespace {

std::string printed(const std::vector<std::string>& words)
{
    const CommandResult run = runLixel(words);
    EXPECT_EQ(run.exitCode, 0) << asTyped(words);
    EXPECT_EQ(run.err, "");
    return run.out;
}

bool holds(const std::string& text, std::string_view word) { return text.find(word) != text.npos; }

TEST(Lists, VersionIsOneLine)
{
    const std::string version = printed({"--version"});
    EXPECT_EQ(version.substr(0, 6), "lixel ");
    EXPECT_EQ(version.find('\n'), version.size() - 1);
}

TEST(Lists, HelpNamesEveryCommandAndItsOptions)
{
    const std::string help = printed({"--help"});
    for (const char* command : {"render", "compare", "reproduce", "study", "merge", "bench", "techniques", "scenes"}) {
        EXPECT_TRUE(holds(help, command));
        EXPECT_TRUE(holds(printed({command, "--help"}), command));
    }
    for (const char* option : {"--view", "--size", "--time", "--path", "--eye", "--fovy", "--light-position",
                               "--technique", "--lixels", "--executor", "--exr", "--exact", "--footprint", "--density"})
        EXPECT_TRUE(holds(printed({"render", "--help"}), option)) << option;
    for (const char* option : {"--techniques", "--frames", "--fps", "--still", "--timing-frames"})
        EXPECT_TRUE(holds(printed({"compare", "--help"}), option)) << option;
}

TEST(Lists, TechniquesHaveEveryWordWithItsLightsAndRefusals)
{
    const std::string list = printed({"techniques"});
    for (const TechniqueWord& word : techniqueWords())
        for (const std::string_view text : {word.kind, word.form, word.meaning, word.paper, word.lights, word.refusals})
            EXPECT_TRUE(holds(list, text)) << text;
}

TEST(Lists, ScenesHaveEveryBuiltInOneAndItsParameters)
{
    const std::string list = printed({"scenes"});
    for (const BuiltinScene& scene : builtinScenes()) {
        EXPECT_TRUE(holds(list, scene.name));
        for (const BuiltinParameter& parameter : scene.parameters)
            EXPECT_TRUE(holds(list, parameter.name)) << parameter.name;
    }
}

TEST(Lists, AScenesViewsAndLightsAreListed)
{
    const std::string list = printed({"scenes", "table"});
    const std::optional<Scene> table = buildBuiltin("table");
    for (const NamedView& view : table->views) {
        EXPECT_TRUE(holds(list, "--view " + view.name));
        for (const Light& light : view.lights) EXPECT_TRUE(holds(list, light.name));
    }
}

TEST(Lists, ASceneTellsItsTrianglesAndItsPath)
{
    for (const BuiltinScene& builtin : builtinScenes()) {
        const std::string list = printed({"scenes", std::string(builtin.name)});
        const auto scene = std::make_shared<const Scene>(*buildBuiltin(builtin.name));
        const std::size_t triangles = evaluate(scene, {}, {}).triangles.triangleCount();
        EXPECT_TRUE(holds(list, std::to_string(triangles) + " triangles")) << list;
        EXPECT_EQ(holds(list, "--path"), !scene->path.empty()) << list;
        if (scene->path.empty()) continue;
        EXPECT_TRUE(holds(list, std::to_string(scene->path.size()) + " keys")) << list;
    }
}

TEST(Lists, ExperimentsAreListedWithTheirPapers)
{
    const std::string list = printed({"reproduce"});
    EXPECT_TRUE(holds(list, "normal-against-focused"));
    EXPECT_TRUE(holds(list, "scene-optimised-table1"));
    EXPECT_TRUE(holds(list, "lixel-fig7"));
    EXPECT_TRUE(holds(list, "Chong"));
}

} // namespace
} // namespace lixel::test
