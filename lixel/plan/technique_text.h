// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

// The text form of techniques, as words and their arguments (technique.h says what they mean).
namespace lixel {

// One word with its arguments, as typed.
struct Word
{
    std::string_view name;
    std::vector<std::string_view> arguments;
};

std::string_view trimmed(std::string_view s);

// Splits at `separator` outside parentheses; nothing where parentheses do not match.
std::optional<std::vector<std::string_view>> split(std::string_view text, char separator);

// word(a, b) or word:a:b.
std::optional<Word> readWord(std::string_view text);

std::optional<int> readInteger(std::string_view text);
std::optional<double> readNumber(std::string_view text); // finite

// The arguments of a word, taken one by one; what is left over is wrong.
class Arguments
{
public:
    explicit Arguments(const Word& word) : left_(word.arguments) {}

    // `key = value`, and the value alone where it may stand without its key.
    std::optional<std::string_view> take(std::string_view key, bool mayStandAlone = false);
    bool takeFlag(std::string_view name);
    bool areAllTaken() const { return left_.empty(); }
    std::span<const std::string_view> rest() const { return left_; }

private:
    std::vector<std::string_view> left_;
};

} // namespace lixel
