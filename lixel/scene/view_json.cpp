// SPDX-License-Identifier: MIT
#include "lixel/scene/view_json.h"

#include "lixel/scene/input_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace lixel {

void JsonPlace::refuse(std::string_view expected) const
{
    lixel::refuse(*file_, pointer_.empty() ? "/" : pointer_, expected);
}

void JsonPlace::expectMembers(std::initializer_list<std::string_view> names) const
{
    const std::string known = fmt::format("{}", fmt::join(names, ", "));
    if (!value_->is_object()) refuse(fmt::format("expected an object with members from: {}", known));
    for (const auto& member : value_->items())
        if (std::find(names.begin(), names.end(), member.key()) == names.end())
            refuse(fmt::format("member \"{}\" is unknown; expected: {}", printable(member.key()), known));
}

bool JsonPlace::has(std::string_view name) const { return value_->contains(name); }

JsonPlace JsonPlace::at(std::string_view name) const
{
    if (!has(name)) refuse(fmt::format("expected a member \"{}\"", name));
    return {(*value_)[std::string(name)], fmt::format("{}/{}", pointer_, name), *file_};
}

std::optional<JsonPlace> JsonPlace::find(std::string_view name) const
{
    if (!has(name)) return std::nullopt;
    return at(name);
}

std::vector<JsonPlace> JsonPlace::elements(std::size_t least) const
{
    if (!value_->is_array() || value_->size() < least) refuse(fmt::format("expected an array of at least {}", least));
    std::vector<JsonPlace> places;
    for (std::size_t i = 0; i < value_->size(); ++i)
        places.emplace_back((*value_)[i], fmt::format("{}/{}", pointer_, i), *file_);
    return places;
}

double JsonPlace::number() const
{
    const double value = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(std::abs(value) <= kMostAbsolute)) refuse(fmt::format("expected a number of at most {}", kMostAbsolute));
    return value;
}

double JsonPlace::numberAbove(double least) const
{
    const double value = number();
    if (!(value > least)) refuse(fmt::format("expected a number greater than {}", least));
    return value;
}

Vec3d JsonPlace::vector() const
{
    if (!value_->is_array() || value_->size() != 3) refuse("expected three numbers [x, y, z]");
    const std::vector<JsonPlace> places = elements(3);
    return {places[0].number(), places[1].number(), places[2].number()};
}

Vec3d JsonPlace::unitVector() const
{
    const Vec3d v = vector();
    if (!(length(v) > 0)) refuse("expected a direction, not [0, 0, 0]");
    return normalized(v);
}

std::string JsonPlace::text() const
{
    if (!value_->is_string()) refuse("expected text");
    return value_->get<std::string>();
}

std::string JsonPlace::name() const
{
    const std::string text = value_->is_string() ? value_->get<std::string>() : std::string();
    const bool isName =
        !text.empty() && text.size() <= 64 &&
        std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
    if (!isName) refuse("expected a name of letters, digits, - and _");
    return text;
}

} // namespace lixel
