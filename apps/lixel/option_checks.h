// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <CLI/CLI.hpp>

// Checks that options are added with, for what the parser itself lets pass.
namespace lixel::app {

// An empty text would count as an option that was not given.
inline CLI::Validator notEmpty()
{
    return {[](const std::string& text) { return std::string(text.empty() ? "a number is expected" : ""); }, ""};
}

// A sign would be taken modulo 2^64.
inline CLI::Validator wholeNumber()
{
    return {[](const std::string& text) {
                const bool isWhole = !text.empty() && text.find_first_not_of("0123456789") == text.npos;
                return std::string(isWhole ? "" : "a whole number from 0 is expected");
            },
            ""};
}

} // namespace lixel::app
