// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lixel::gltf {

// Coordinates beyond this are refused: their squares, and sums of these, must still be numbers.
inline constexpr double kMostCoordinate = 1e30;

// A JSON value that knows where it stands, so that every wrong one is named: "scene.gltf: accessors[3].count: expected
// ...". All reading of glTF goes through this; what it returns has the type and range that was asked for. It does not
// own the value.
class JsonAt
{
public:
    JsonAt(const nlohmann::json& value, std::string place, const std::string& file)
        : value_(&value), file_(&file), place_(std::move(place))
    {
    }

    const std::string& place() const { return place_; }
    const std::string& file() const { return *file_; }
    [[noreturn]] void refuse(std::string_view expected) const;

    // Of an object: a member, if it is there; a member that must be there.
    std::optional<JsonAt> find(const char* key) const;
    JsonAt require(const char* key) const;
    const nlohmann::json::object_t& members() const;

    // Of an array.
    std::size_t size() const;
    JsonAt operator[](std::size_t i) const;

    double number(double least = -kMostCoordinate, double most = kMostCoordinate) const; // finite
    std::size_t integer(std::size_t least, std::size_t most) const;
    int index(std::size_t count, const char* what) const; // one of `count` things called `what`
    bool boolean() const;
    const std::string& text() const;
    template <std::size_t N>
    std::array<double, N> numbers() const
    {
        if (size() != N) refuse("expected " + std::to_string(N) + " numbers");
        std::array<double, N> all;
        for (std::size_t i = 0; i < N; ++i) all[i] = (*this)[i].number();
        return all;
    }

    // Members with a default.
    double numberOr(const char* key, double standard, double least = -kMostCoordinate,
                    double most = kMostCoordinate) const;
    std::size_t integerOr(const char* key, std::size_t standard, std::size_t least, std::size_t most) const;
    int indexOr(const char* key, std::size_t count, const char* what) const; // -1 where there is none
    std::string textOr(const char* key, const std::string& standard) const;

private:
    const nlohmann::json* value_;
    const std::string* file_;
    std::string place_;
};

} // namespace lixel::gltf
