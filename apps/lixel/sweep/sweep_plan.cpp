// SPDX-License-Identifier: MIT
#include "sweep/sweep_plan.h"

#include "exit_code.h"
#include "lixel/scene/load.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lixel::app {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostTrianglesKept = 8'000'000; // about a gigabyte

std::size_t trianglesOf(const Scene& scene)
{
    return std::transform_reduce(scene.meshes.begin(), scene.meshes.end(), std::size_t(0), std::plus<>(),
                                 [](const Mesh& mesh) { return mesh.indices.size() / 3; });
}

// A name of a plane that no scene of the study has is a slip; one that some scenes lack makes refused rows there.
void expectPlanesSomewhere(const SweepFile& file, const std::vector<Shooting>& shootings)
{
    for (std::size_t i = 0; i < file.techniques.size(); ++i) {
        std::string wrong;
        const auto isWrong = [&](const Shooting& shooting) {
            try {
                expectPlanes({&file.techniques[i], 1}, shooting);
                return false;
            } catch (const UsageError& error) {
                wrong = error.what();
                return true;
            }
        };
        if (std::ranges::all_of(shootings, isWrong)) refuseAt(file, fmt::format("/techniques/{}", i), wrong);
    }
}

// Pictures and lights of one view of the file, for every size and set of lights.
void addGroups(const SweepFile& file, const Shooting& shooting, SweepGroup group, std::vector<SweepGroup>& groups)
{
    for (const Shot& shot : shooting.shots)
        for (group.size = 0; group.size < file.sizes.size(); ++group.size)
            for (group.lights = 0; group.lights < file.lights.size(); ++group.lights) {
                group.view = shot.name;
                group.lightNames.clear();
                for (const Light& light : file.lights[group.lights].of(shot.lights, file.seed))
                    group.lightNames.push_back(light.name);
                groups.push_back(group);
            }
}

void expectViewsOnce(const SweepFile& file, const std::vector<SweepGroup>& groups)
{
    std::set<std::tuple<std::size_t, double, std::string, std::size_t, std::size_t>> taken;
    for (const SweepGroup& group : groups)
        if (!taken.insert({group.scene, group.timeSeconds, group.view, group.size, group.lights}).second)
            refuseAt(file, fmt::format("/scenes/{}", group.scene),
                     fmt::format("view \"{}\" at {} s is asked for twice", group.view, group.timeSeconds));
}

} // namespace

std::shared_ptr<const Scene> SceneShelf::open(const std::string& path)
{
    auto& known = scenes_[path];
    if (known) return known;
    if (triangles_ > kMostTrianglesKept) {
        scenes_.clear();
        triangles_ = 0;
    }
    const std::shared_ptr<const Scene> scene = openScene(path);
    triangles_ += trianglesOf(*scene);
    if (triangles_ > kMostTrianglesKept) scenes_.clear();
    return scenes_[path] = scene;
}

Shooting shootingOf(const SweepFile& file, const SweepGroup& group, SceneShelf& shelf)
{
    const SweepScene& scene = file.scenes[group.scene];
    const std::string& view = scene.views[group.viewOfFile];
    PictureOptions options;
    options.scene = scene.path;
    options.view = viewOption(file, view);
    options.size = file.sizes[group.size];
    options.time = file.times[group.time];
    try {
        Shooting shooting = prepare(options, true, shelf.open(scene.path));
        shooting.sceneName = scene.text;
        if (options.view != view) shooting.shots.front().name = view; // a view file's, without this machine's folder
        return shooting;
    } catch (const UsageError& error) {
        refuseAt(file, fmt::format("/scenes/{}", group.scene), error.what());
    }
}

SweepPlan planSweep(const SweepFile& file, SceneShelf& shelf)
{
    SweepPlan plan{file.name, file.hash, LIXEL_VERSION, file.executor, file.question, file.seed, {}, file.sizes, {}, {},
                   {},        {}};
    for (const SweepScene& scene : file.scenes) plan.scenes.push_back(scene.text);
    for (const SweepLights& set : file.lights) plan.lights.push_back(set.name);
    for (const LixelBudget& budget : file.lixels) plan.lixels.push_back(toString(budget));
    for (const TechniqueChoice& choice : file.techniques)
        plan.techniques.push_back(
            {choice.typed, toString(choice.technique), std::holds_alternative<MapTechnique>(choice.technique)});
    std::vector<Shooting> shootings; // one of each view
    SweepGroup group;
    for (group.scene = 0; group.scene < file.scenes.size(); ++group.scene)
        for (group.time = 0; group.time < file.times.size(); ++group.time)
            for (group.viewOfFile = 0; group.viewOfFile < file.scenes[group.scene].views.size(); ++group.viewOfFile) {
                Shooting shooting = shootingOf(file, group, shelf);
                group.timeSeconds = shooting.evaluateOptions.time;
                addGroups(file, shooting, group, plan.groups);
                shooting.scene = nullptr;
                shootings.push_back(std::move(shooting));
            }
    expectViewsOnce(file, plan.groups);
    expectPlanesSomewhere(file, shootings);
    return plan;
}

std::vector<SweepCell> SweepPlan::cells() const
{
    std::vector<SweepCell> out;
    std::size_t row = 0;
    for (std::size_t group = 0; group < groups.size(); ++group)
        for (std::size_t technique = 0; technique < techniques.size(); ++technique) {
            const bool hasMap = techniques[technique].hasMap;
            for (std::size_t budget = 0; budget < (hasMap ? lixels.size() : 1); ++budget) {
                const std::size_t rows = groups[group].lightNames.size();
                out.push_back({group, technique, hasMap ? lixels[budget] : "", budget, row, rows});
                row += rows;
            }
        }
    return out;
}

std::string SweepPlan::keyOf(const SweepCell& cell, std::size_t light) const
{
    const SweepGroup& group = groups[cell.group];
    return fmt::format("{} | {} | {} s | {} | {} | {} | {} | {} | {} | {} | {}", scenes[group.scene], group.view,
                       group.timeSeconds, lights[group.lights], group.lightNames[light],
                       techniques[cell.technique].full, cell.lixels.empty() ? "no map" : cell.lixels, sizes[group.size],
                       executor, seed, lixelVersion);
}

std::string toJson(const SweepPlan& plan)
{
    Json techniques = Json::array(), groups = Json::array();
    for (const auto& one : plan.techniques)
        techniques.push_back({{"technique", one.typed}, {"technique_full", one.full}, {"has_map", one.hasMap}});
    for (const SweepGroup& group : plan.groups)
        groups.push_back({{"scene", group.scene},
                          {"view_of_file", group.viewOfFile},
                          {"time", group.time},
                          {"size", group.size},
                          {"lights", group.lights},
                          {"view", group.view},
                          {"time_seconds", group.timeSeconds},
                          {"light_names", group.lightNames}});
    const Json json = {{"study", plan.study},       {"question", plan.question},
                       {"hash", plan.hash},         {"lixel_version", plan.lixelVersion},
                       {"executor", plan.executor}, {"seed", plan.seed},
                       {"scenes", plan.scenes},     {"sizes", plan.sizes},
                       {"lights", plan.lights},     {"lixels", plan.lixels},
                       {"techniques", techniques},  {"groups", groups}};
    return json.dump();
}

namespace {

// Every place in a list is within it: what follows may take it as it is.
bool isWhole(const SweepPlan& plan)
{
    const auto isWithin = [&](const SweepGroup& group) {
        return group.scene < plan.scenes.size() && group.size < plan.sizes.size() &&
               group.lights < plan.lights.size() && !group.lightNames.empty();
    };
    return !plan.techniques.empty() && !plan.lixels.empty() && std::ranges::all_of(plan.groups, isWithin);
}

} // namespace

std::optional<SweepPlan> readPlan(std::string_view text)
{
    try {
        const Json json = Json::parse(text);
        SweepPlan plan;
        json.at("study").get_to(plan.study);
        json.at("question").get_to(plan.question);
        json.at("hash").get_to(plan.hash);
        json.at("lixel_version").get_to(plan.lixelVersion);
        json.at("executor").get_to(plan.executor);
        json.at("seed").get_to(plan.seed);
        json.at("scenes").get_to(plan.scenes);
        json.at("sizes").get_to(plan.sizes);
        json.at("lights").get_to(plan.lights);
        json.at("lixels").get_to(plan.lixels);
        for (const Json& one : json.at("techniques"))
            plan.techniques.push_back({one.at("technique"), one.at("technique_full"), one.at("has_map")});
        for (const Json& one : json.at("groups"))
            plan.groups.push_back({one.at("scene"), one.at("view_of_file"), one.at("time"), one.at("size"),
                                   one.at("lights"), one.at("view"), one.at("time_seconds"),
                                   one.at("light_names").get<std::vector<std::string>>()});
        return isWhole(plan) ? std::optional(plan) : std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

} // namespace lixel::app
