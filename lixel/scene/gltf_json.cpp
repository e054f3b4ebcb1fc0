// SPDX-License-Identifier: MIT
#include "lixel/scene/gltf_json.h"

#include "lixel/scene/input_file.h"

#include <fmt/format.h>

#include <cmath>

namespace lixel::gltf {

void JsonAt::refuse(std::string_view expected) const { lixel::refuse(*file_, place_, expected); }

std::optional<JsonAt> JsonAt::find(const char* key) const
{
    const auto& object = members();
    const auto found = object.find(key);
    if (found == object.end()) return std::nullopt;
    return JsonAt(found->second, place_.empty() ? std::string(key) : place_ + "." + key, *file_);
}

JsonAt JsonAt::require(const char* key) const
{
    if (std::optional<JsonAt> member = find(key)) return *std::move(member);
    refuse(fmt::format("expected '{}'", key));
}

const nlohmann::json::object_t& JsonAt::members() const
{
    if (!value_->is_object()) refuse("expected an object");
    return value_->get_ref<const nlohmann::json::object_t&>();
}

std::size_t JsonAt::size() const
{
    if (!value_->is_array()) refuse("expected an array");
    return value_->size();
}

JsonAt JsonAt::operator[](std::size_t i) const
{
    if (i >= size()) refuse(fmt::format("expected more than {} elements", i));
    return JsonAt((*value_)[i], fmt::format("{}[{}]", place_, i), *file_);
}

double JsonAt::number(double least, double most) const
{
    const double value = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(value >= least && value <= most)) refuse(fmt::format("expected a number from {} to {}", least, most));
    return value;
}

std::size_t JsonAt::integer(std::size_t least, std::size_t most) const
{
    // Written 3 or 3.0: glTF allows both. Up to 2^53 the double is the integer.
    const double value = value_->is_number() ? value_->get<double>() : -1;
    if (!(value >= double(least) && value <= double(most) && value <= 0x1p53) || value != std::floor(value))
        refuse(fmt::format("expected an integer from {} to {}", least, most));
    return std::size_t(value);
}

int JsonAt::index(std::size_t count, const char* what) const
{
    if (count == 0) refuse(fmt::format("expected no index: the file has no {}", what));
    const double value = value_->is_number() ? value_->get<double>() : -1;
    if (!(value >= 0 && value < double(count)) || value != std::floor(value))
        refuse(fmt::format("expected the index of one of the {} {}", count, what));
    return int(value);
}

bool JsonAt::boolean() const
{
    if (!value_->is_boolean()) refuse("expected true or false");
    return value_->get<bool>();
}

const std::string& JsonAt::text() const
{
    if (!value_->is_string()) refuse("expected a text");
    return value_->get_ref<const std::string&>();
}

double JsonAt::numberOr(const char* key, double standard, double least, double most) const
{
    const auto member = find(key);
    return member ? member->number(least, most) : standard;
}

std::size_t JsonAt::integerOr(const char* key, std::size_t standard, std::size_t least, std::size_t most) const
{
    const auto member = find(key);
    return member ? member->integer(least, most) : standard;
}

int JsonAt::indexOr(const char* key, std::size_t count, const char* what) const
{
    const auto member = find(key);
    return member ? member->index(count, what) : -1;
}

std::string JsonAt::textOr(const char* key, const std::string& standard) const
{
    const auto member = find(key);
    return member ? member->text() : standard;
}

} // namespace lixel::gltf
