// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin.h"

#include "lixel/scene/builtin/scenes.h"
#include "lixel/scene/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace lixel {

namespace {

std::string namesOf(std::span<const BuiltinParameter> parameters)
{
    std::string names;
    for (const BuiltinParameter& p : parameters)
        names += fmt::format("{}{}={:.0f} ({:.0f} to {:.0f})", names.empty() ? "" : ", ", p.name, p.standard, p.least,
                             p.most);
    return names;
}

double parseValue(std::string_view scene, const BuiltinParameter& parameter, std::string_view text)
{
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = !text.empty() && error == std::errc() && end == text.data() + text.size();
    if (!isWhole || double(value) < parameter.least || double(value) > parameter.most)
        throw InputError(fmt::format("scene {}: {}={}: expected a whole number from {:.0f} to {:.0f}", scene,
                                     parameter.name, text, parameter.least, parameter.most));
    return double(value);
}

// Arguments are key=value; a value alone is that of the parameter in its place.
std::vector<double> parseArguments(const BuiltinScene& scene, std::string_view arguments)
{
    std::vector<double> values;
    for (const BuiltinParameter& p : scene.parameters) values.push_back(p.standard);
    std::vector<bool> given(values.size());
    for (std::size_t place = 0; !arguments.empty(); ++place) {
        const std::size_t comma = arguments.find(',');
        const std::string_view argument = arguments.substr(0, comma);
        arguments = comma == arguments.npos ? std::string_view() : arguments.substr(comma + 1);

        const std::size_t equals = argument.find('=');
        const std::string_view key = equals == argument.npos ? std::string_view() : argument.substr(0, equals);
        std::size_t index = place;
        if (equals != argument.npos)
            index = std::size_t(std::ranges::find(scene.parameters, key, &BuiltinParameter::name) -
                                scene.parameters.begin());
        if (index >= values.size())
            throw InputError(fmt::format("scene {}: \"{}\" is not one of its parameters: {}", scene.name, argument,
                                         namesOf(scene.parameters)));
        if (given[index])
            throw InputError(fmt::format("scene {}: {} is given twice", scene.name, scene.parameters[index].name));
        given[index] = true;
        values[index] = parseValue(scene.name, scene.parameters[index],
                                   equals == argument.npos ? argument : argument.substr(equals + 1));
    }
    return values;
}

} // namespace

std::span<const BuiltinScene> builtinScenes()
{
    static const std::array scenes = {builtin::kBunnies, builtin::kTable, builtin::kObjects, builtin::kColonnade,
                                      builtin::kFence,   builtin::kCity,  builtin::kLamp,    builtin::kBalls};
    return scenes;
}

std::optional<Scene> buildBuiltin(std::string_view text)
{
    const std::size_t wordEnd = text.find_first_of("(:");
    const std::string_view word = text.substr(0, wordEnd);
    const auto scene = std::ranges::find(builtinScenes(), word, &BuiltinScene::name);
    if (scene == builtinScenes().end()) return std::nullopt;

    // name, name(arguments), or name:arguments so that a shell needs no quotes.
    std::string_view arguments;
    if (wordEnd != text.npos) {
        arguments = text.substr(wordEnd + 1);
        if (text[wordEnd] == '(') {
            if (!arguments.ends_with(')'))
                throw InputError(
                    fmt::format("scene {}: expected {}(...) with a closing parenthesis at the end", text, word));
            arguments.remove_suffix(1);
        }
    }
    return scene->build(parseArguments(*scene, arguments));
}

} // namespace lixel
