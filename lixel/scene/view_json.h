// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/light.h"
#include "lixel/base/vec.h"

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lixel {

// Numbers beyond this are taken for mistakes: their squares still fit into floats' exponents.
inline constexpr double kMostAbsolute = 1e12;

// A place in a JSON file, which the caller keeps, that knows where it is: everything it cannot give is an InputError
// "file: pointer: expected".
class JsonPlace
{
public:
    JsonPlace(const nlohmann::json& value, std::string pointer, const std::string& file)
        : value_(&value), pointer_(std::move(pointer)), file_(&file)
    {
    }

    [[noreturn]] void refuse(std::string_view expected) const;

    // An object with no other members than these.
    void expectMembers(std::initializer_list<std::string_view> names) const;
    bool has(std::string_view name) const;
    JsonPlace at(std::string_view name) const; // refuses, here, where the member is missing
    std::optional<JsonPlace> find(std::string_view name) const;

    std::vector<JsonPlace> elements(std::size_t least) const;
    bool isArray() const { return value_->is_array(); }
    bool isObject() const { return value_->is_object(); }

    double number() const;                  // finite, at most kMostAbsolute
    double numberAbove(double least) const; // likewise and > least
    Vec3d vector() const;                   // three such numbers
    Vec3d unitVector() const;               // likewise, of some length; made unit
    std::string text() const;               // any
    std::string name() const;               // letters, digits, '-' and '_', at most 64

private:
    const nlohmann::json* value_;
    std::string pointer_;
    const std::string* file_;
};

// What a view file has under "light" or "lights"; none where it has neither.
std::vector<Light> readLights(const JsonPlace& file);

} // namespace lixel
