// SPDX-License-Identifier: MIT
#include "lixel/scene/obj_text.h"

#include "lixel/scene/input_file.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace lixel::obj {
namespace {

constexpr double kMostCoordinate = 1e30;
constexpr long long kMostIndex = 1'000'000'000;

constexpr std::size_t kPosition = 0, kUv = 1, kNormal = 2, kKinds = 3; // in the order of a face's i/j/k

// Takes the next word off the front; empty at the end.
std::string_view takeWord(std::string_view& line)
{
    const std::size_t start = std::min(line.find_first_not_of(" \t"), line.size());
    line.remove_prefix(start);
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    line.remove_prefix(word.size());
    return word;
}

std::optional<double> asNumber(std::string_view word)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return std::abs(value) <= kMostCoordinate ? std::optional(value) : std::nullopt;
}

class Checker
{
public:
    explicit Checker(const std::string& file) : file_(file) {}

    void line(std::string_view line, int number)
    {
        number_ = number;
        const std::string_view keyword = takeWord(line);
        if (keyword == "v") countNumbers(line, kPosition, 3);
        else if (keyword == "vt") countNumbers(line, kUv, 1);
        else if (keyword == "vn") countNumbers(line, kNormal, 3);
        else if (keyword == "f") face(line);
        else if (keyword == "mtllib" && line.find_first_not_of(" \t") != line.npos)
            materialFiles.emplace_back(line.substr(line.find_first_not_of(" \t")));
    }

    // Positive indices may point forward, so they are judged when all is known.
    void finish() const
    {
        for (std::size_t kind = 0; kind < kKinds; ++kind) {
            const Most& most = most_[kind];
            if (most.index > counts_[kind])
                refuse(file_, fmt::format("line {}", most.line),
                       fmt::format("expected indices up to {}, found {}", counts_[kind], most.index));
        }
    }

    std::vector<std::string> materialFiles;

private:
    struct Most
    {
        long long index = 0;
        int line = 0;
    };

    [[noreturn]] void refuseLine(std::string_view expected) const
    {
        refuse(file_, fmt::format("line {}", number_), expected);
    }

    void countNumbers(std::string_view line, std::size_t kind, int least)
    {
        int found = 0;
        for (std::string_view word = takeWord(line); !word.empty() && !word.starts_with('#'); word = takeWord(line)) {
            if (!asNumber(word)) refuseLine(fmt::format("expected a number up to 1e30, found '{}'", printable(word)));
            ++found;
        }
        if (found < least) refuseLine(fmt::format("expected {} numbers, found {}", least, found));
        ++counts_[kind];
    }

    void face(std::string_view line)
    {
        for (std::string_view corner = takeWord(line); !corner.empty(); corner = takeWord(line)) {
            const std::string_view whole = corner;
            for (std::size_t kind = 0; kind < kKinds; ++kind) {
                const std::string_view part = corner.substr(0, corner.find('/'));
                if (!part.empty()) index(part, kind);
                if (part.empty() && (kind == kPosition || part.size() == corner.size())) refuseCorner(whole);
                if (part.size() == corner.size()) break;
                if (kind == kNormal) refuseCorner(whole); // a third '/'
                corner.remove_prefix(part.size() + 1);
            }
        }
    }

    [[noreturn]] void refuseCorner(std::string_view corner) const
    {
        refuseLine(fmt::format("expected a corner i, i/j, i//k or i/j/k, found '{}'", printable(corner)));
    }

    void index(std::string_view text, std::size_t kind)
    {
        long long value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool isIndex = error == std::errc{} && end == text.data() + text.size();
        if (!isIndex || value == 0 || std::abs(value) > kMostIndex)
            refuseLine(fmt::format("expected an index other than 0, up to 1e9, found '{}'", printable(text)));
        if (value < -counts_[kind])
            refuseLine(fmt::format("expected indices from {}, found {}", -counts_[kind], value));
        if (value > most_[kind].index) most_[kind] = {value, number_};
    }

    const std::string& file_;
    int number_ = 0;
    std::array<long long, kKinds> counts_{};
    std::array<Most, kKinds> most_{};
};

} // namespace

CheckedText checkObj(std::string_view text, const std::string& file)
{
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    if (text.empty()) refuse(file, "", "is empty");
    if (text.find('\0') != text.npos) refuse(file, "", "expected OBJ text, found a zero byte");

    Checker checker(file);
    CheckedText checked;
    std::string line; // with the lines it is continued on
    int number = 0, firstNumber = 1;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        line += text.substr(0, end);
        text.remove_prefix(end);
        text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
        ++number;
        if (line.ends_with('\\') && !text.empty()) {
            line.back() = ' ';
            continue;
        }
        line.erase(line.find_last_not_of(" \t") + 1); // names must not end in spaces
        checker.line(line, firstNumber);
        checked.text += line + '\n';
        line.clear(), firstNumber = number + 1;
    }
    checker.finish();
    checked.materialFiles = std::move(checker.materialFiles);
    return checked;
}

} // namespace lixel::obj
