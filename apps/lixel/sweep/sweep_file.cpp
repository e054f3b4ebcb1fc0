// SPDX-License-Identifier: MIT
#include "sweep/sweep_file.h"

#include "exit_code.h"
#include "lixel/scene/builtin.h"
#include "lixel/scene/hemisphere_lights.h"
#include "lixel/scene/input_file.h"
#include "lixel/scene/json_text.h"
#include "lixel/scene/view_json.h"
#include "run_results.h"

#include <cmath>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace lixel::app {
namespace {

constexpr std::size_t kMostValues = 10'000; // of one list
constexpr int kMostSuns = 1024;
constexpr int kMostPixelsASide = 8192;
constexpr std::uint64_t kMostSeed = std::uint64_t(1) << 53; // doubles hold every whole number below

// FNV-1a, 64 bits: tells files apart that nobody made to collide.
class Hash
{
public:
    void add(std::string_view bytes)
    {
        for (const char c : bytes) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        value_ = (value_ ^ 0x100u) * 0x100000001b3u; // where one text ends and the next begins
    }
    std::string text() const { return fmt::format("{:016x}", value_); }

private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

// Throws what the command line says of an option at the place of the file instead.
template <typename Read>
auto readAt(const JsonPlace& place, const Read& read)
{
    try {
        return read();
    } catch (const UsageError& error) {
        place.refuse(error.what());
    }
}

bool isFileName(std::string_view text)
{
    return text.substr(0, text.find_first_of("(:")).find_first_of("/.") != text.npos;
}

// The same study must run elsewhere: no place of one machine.
void expectRelative(const JsonPlace& place, const std::string& path)
{
    if (std::filesystem::path(path).is_absolute() || path.starts_with('~'))
        place.refuse("expected a path relative to this file's folder");
}

std::vector<JsonPlace> listAt(const JsonPlace& place)
{
    std::vector<JsonPlace> elements = place.elements(1);
    if (elements.size() > kMostValues) place.refuse(fmt::format("expected at most {} elements", kMostValues));
    return elements;
}

// Values that combine: the same one twice would be the same rows twice.
template <typename T, typename Read>
std::vector<T> readList(const JsonPlace& place, const Read& read)
{
    std::vector<T> values;
    std::set<std::string> taken;
    for (const JsonPlace& element : listAt(place)) {
        std::string name;
        values.push_back(read(element, name));
        if (!taken.insert(name).second) element.refuse(fmt::format("\"{}\" stands here twice", printable(name)));
    }
    return values;
}

int wholeNumber(const JsonPlace& place, int least, int most)
{
    const double value = place.number();
    if (!(value >= least && value <= most && value == std::floor(value)))
        place.refuse(fmt::format("expected a whole number from {} to {}", least, most));
    return int(value);
}

std::vector<std::string> readViews(const JsonPlace& place)
{
    return readList<std::string>(place, [](const JsonPlace& view, std::string& name) {
        name = view.text();
        if (name.empty()) view.refuse("expected \"all\", the name of a view, or a view file");
        if (name.find('/') != name.npos || name.ends_with(".json")) expectRelative(view, name);
        return name;
    });
}

SweepScene readScene(const JsonPlace& place, const std::vector<std::string>& views, const std::filesystem::path& folder)
{
    SweepScene scene{{}, {}, views};
    JsonPlace named = place;
    if (place.isObject()) {
        place.expectMembers({"scene", "views"});
        named = place.at("scene");
        if (const auto own = place.find("views")) scene.views = readViews(*own);
    }
    scene.text = named.text();
    if (scene.text.empty()) named.refuse("expected a built-in scene, or a .gltf, .glb or .obj file");
    const bool isFile = isFileName(scene.text);
    if (isFile) expectRelative(named, scene.text);
    // A file of the same folder must still look like one.
    const std::filesystem::path path = folder / scene.text;
    scene.path = !isFile ? scene.text : path.has_parent_path() ? path.string() : "./" + path.string();
    return scene;
}

SweepLights readLightSet(const JsonPlace& place)
{
    if (!place.isObject()) {
        if (place.text() != "own")
            place.refuse("expected \"own\", {\"suns\": number} or {\"name\": ..., \"lights\": [...]}");
        return {"own", 0, {}};
    }
    if (const auto suns = place.find("suns")) {
        place.expectMembers({"suns"});
        const int count = wholeNumber(*suns, 1, kMostSuns);
        return {fmt::format("suns-{}", count), count, {}};
    }
    place.expectMembers({"name", "lights", "light"});
    SweepLights set{place.at("name").name(), 0, readLights(place)};
    if (set.lights.empty()) place.refuse("expected \"lights\", as a view file has them");
    if (set.name == "own" || set.name.starts_with("suns-")) place.at("name").refuse("expected another name");
    return set;
}

TechniqueChoice readTechniqueAt(const JsonPlace& place, const std::filesystem::path& folder, std::string& name)
{
    const std::string text = place.text();
    TechniqueChoice choice = readAt(place, [&] {
        if (const auto technique = parseTechnique(text)) expectRelative(place, fileNamedBy(*technique));
        return chooseTechnique(text, folder);
    });
    name = toString(choice.technique);
    return choice;
}

void readCombined(const JsonPlace& place, SweepFile& file)
{
    std::vector<std::string> views{"all"};
    if (const auto given = place.find("views")) views = readViews(*given);
    file.scenes = readList<SweepScene>(place.at("scenes"), [&](const JsonPlace& scene, std::string& name) {
        SweepScene read = readScene(scene, views, file.folder());
        name = read.text;
        return read;
    });
    file.techniques = readList<TechniqueChoice>(place.at("techniques"), [&](const JsonPlace& one, std::string& name) {
        return readTechniqueAt(one, file.folder(), name);
    });
    file.lixels = readList<LixelBudget>(place.at("lixels"), [](const JsonPlace& one, std::string& name) {
        name = one.text();
        const LixelBudget budget = readAt(one, [&] { return readBudget(name, "lixels", kMostLixelsASide); });
        name = toString(budget);
        return budget;
    });
    file.sizes = readList<std::string>(place.at("sizes"), [](const JsonPlace& one, std::string& name) {
        name = readAt(one, [&] { return toString(readSize(one.text(), "sizes", kMostPixelsASide)); });
        return name;
    });
    file.times = {std::nullopt};
    if (const auto times = place.find("times"))
        file.times = readList<std::optional<double>>(*times, [](const JsonPlace& one, std::string& name) {
            const double seconds = one.number();
            if (!(seconds >= 0)) one.refuse("expected a number of seconds from 0");
            name = fmt::format("{}", seconds);
            return std::optional(seconds);
        });
    file.lights = {{"own", 0, {}}};
    if (const auto lights = place.find("lights"))
        file.lights = readList<SweepLights>(*lights, [](const JsonPlace& one, std::string& name) {
            SweepLights set = readLightSet(one);
            name = set.name;
            return set;
        });
}

std::string_view textOf(const std::vector<std::byte>& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// How the file is laid out is nothing, what it says is all; what it names belongs to it.
std::string hashOf(const SweepFile& file, const nlohmann::json& json)
{
    Hash hash;
    hash.add(json.dump());
    const auto addFile = [&](const std::string& path) { hash.add(textOf(readInputFile(path))); };
    for (const SweepScene& scene : file.scenes) {
        if (scene.path != scene.text || isFileName(scene.text)) addFile(scene.path);
        for (const std::string& view : scene.views)
            if (viewOption(file, view) != view) addFile(viewOption(file, view));
    }
    for (const TechniqueChoice& choice : file.techniques)
        if (const std::string plan = fileNamedBy(choice.technique); !plan.empty())
            addFile((file.folder() / plan).string());
    return hash.text();
}

} // namespace

std::vector<Light> SweepLights::of(const std::vector<Light>& own, std::uint64_t seed) const
{
    if (suns > 0) return hemisphereLights(seed, suns);
    return lights.empty() ? own : lights;
}

SweepFile readSweepFile(const std::filesystem::path& path)
{
    const std::string name = path.string();
    const nlohmann::json json = parseJson(readJsonFile(name), name);
    const JsonPlace place(json, "", name);
    place.expectMembers({"question", "scenes", "views", "times", "sizes", "lights", "techniques", "lixels", "executor",
                         "seed", "timing_frames"});
    SweepFile file;
    file.path = path;
    file.name = sceneName(name);
    if (const auto question = place.find("question")) file.question = question->text();
    file.executor = "gl";
    if (const auto executor = place.find("executor")) {
        file.executor = executor->text();
        if (file.executor != "gl" && file.executor != "trace") executor->refuse("expected \"gl\" or \"trace\"");
    }
    if (const auto seed = place.find("seed")) {
        const double value = seed->number();
        if (!(value >= 0 && value <= double(kMostSeed) && value == std::floor(value)))
            seed->refuse("expected a whole number from 0");
        file.seed = std::uint64_t(value);
    }
    file.timingFrames = 5;
    if (const auto frames = place.find("timing_frames")) file.timingFrames = wholeNumber(*frames, 0, 1000);
    readCombined(place, file);
    file.hash = hashOf(file, json);
    return file;
}

void refuseAt(const SweepFile& file, const std::string& place, const std::string& what)
{
    refuse(file.path.string(), place, what);
}

std::string viewOption(const SweepFile& file, const std::string& view)
{
    const bool isFile = view.find('/') != view.npos || view.ends_with(".json");
    if (!isFile) return view;
    const std::filesystem::path path = file.folder() / view;
    return path.has_parent_path() ? path.string() : "./" + path.string();
}

} // namespace lixel::app
