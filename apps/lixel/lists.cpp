// SPDX-License-Identifier: MIT
#include "commands.h"
#include "exit_code.h"
#include "lixel/plan/technique.h"
#include "lixel/scene/builtin.h"
#include "lixel/scene/evaluate.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <span>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// `lixel techniques` and `lixel scenes`: what there is.
namespace lixel::app {
namespace {

int printTechniques()
{
    fmt::print("A technique is words joined by +, in any order: at most one of each kind, any fit in any partition.\n"
               "Left out: whole + focused + depths(1) + pcf(1), no else(...); sdsm goes with desired-view. Arguments "
               "in parentheses may\n"
               "be left out too. word:a means word(a), so that a shell needs no quotes.\n\n");
    std::string_view kind;
    for (const TechniqueWord& word : techniqueWords()) {
        if (word.kind != kind) fmt::print("{}\n", word.kind);
        kind = word.kind;
        const bool fits = word.form.size() <= 15;
        fmt::print("  {:<15}{}{}\n", word.form, fits ? " " : "\n                  ", word.meaning);
        if (!word.paper.empty()) fmt::print("  {:<15} {}\n", "", word.paper);
        fmt::print("  {:<15} lights: {}{}\n", "", word.lights,
                   word.refusals.empty() ? "" : fmt::format("; refuses: {}", word.refusals));
    }
    return kDone;
}

bool movesLight(std::span<const PathKey> path)
{
    return std::ranges::any_of(path,
                               [](const PathKey& key) { return key.lightPositionWorld || key.lightDirectionWorld; });
}

int printScenes(const std::string& only)
{
    bool found = only.empty();
    for (const BuiltinScene& builtin : builtinScenes()) {
        if (!only.empty() && only != builtin.name) continue;
        found = true;
        fmt::print("{:<11} {}\n", builtin.name, builtin.description);
        for (const BuiltinParameter& p : builtin.parameters)
            fmt::print("{:<11}   {}={:.0f}  {} ({:.0f} to {:.0f})\n", "", p.name, p.standard, p.meaning, p.least,
                       p.most);
        if (only.empty()) continue;
        const auto built = std::make_shared<const Scene>(*buildBuiltin(std::string(builtin.name)));
        const Scene& scene = *built;
        fmt::print("{:<11}   {} triangles\n", "", evaluate(built, {}, {}).triangles.triangleCount());
        if (!scene.path.empty())
            fmt::print("  --path   camera{} from {:g} s to {:g} s, by {} keys\n",
                       movesLight(scene.path) ? " and light" : "", scene.path.front().time, scene.path.back().time,
                       scene.path.size());
        for (const NamedView& view : scene.views) {
            std::string lights;
            for (const Light& light : view.lights) lights += (lights.empty() ? "" : ", ") + light.name;
            fmt::print("  --view {:<18} {} [{}]\n", view.name, view.description, lights);
        }
    }
    if (!found) throw UsageError(fmt::format("scene \"{}\" is not built in (lixel scenes)", only));
    if (only.empty())
        fmt::print("\nlixel scenes NAME lists its views, its path and how large it is. Any other SCENE is a .gltf, "
                   ".glb or .obj file.\n");
    return kDone;
}

} // namespace

Command addTechniques(CLI::App& parent)
{
    CLI::App* app = parent.add_subcommand("techniques", "the words techniques are made of");
    return {app, printTechniques};
}

Command addScenes(CLI::App& parent)
{
    auto only = std::make_shared<std::string>();
    CLI::App* app =
        parent.add_subcommand("scenes", "the built-in scenes; with a name, its size, path, views and lights");
    app->add_option("NAME", *only, "one of them");
    return {app, [only] { return printScenes(*only); }};
}

} // namespace lixel::app
