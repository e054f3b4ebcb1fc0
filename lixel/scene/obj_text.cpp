// SPDX-License-Identifier: MIT
#include "lixel/scene/obj_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

namespace lixel::obj {
namespace {

constexpr double kMostCoordinate = 1e30;
constexpr std::size_t kMostMaterialFiles = 1000;
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

// Cuts text that comes in blocks into lines. One that ends in a backslash goes on with the next; its number is its first line's.
class Lines
{
public:
    explicit Lines(std::function<void(std::string_view, long long)> each) : each_(std::move(each)) {}

    void add(std::string_view block)
    {
        while (!block.empty()) {
            if (afterReturn_ && block.front() == '\n') block.remove_prefix(1);
            afterReturn_ = false;
            const std::size_t end = std::min(block.find_first_of("\r\n"), block.size());
            line_ += block.substr(0, end);
            block.remove_prefix(end);
            if (block.empty()) return;
            afterReturn_ = block.front() == '\r';
            block.remove_prefix(1);
            ++number_;
            if (line_.ends_with('\\')) line_.back() = ' ';
            else if (line_.empty()) firstNumber_ = number_ + 1;
            else give();
        }
    }

    void finish()
    {
        if (line_.empty()) return;
        ++number_;
        give();
    }

private:
    void give()
    {
        line_.erase(line_.find_last_not_of(" \t") + 1); // names must not end in spaces
        each_(line_, firstNumber_);
        line_.clear(), firstNumber_ = number_ + 1;
    }

    std::function<void(std::string_view, long long)> each_;
    std::string line_;
    long long number_ = 0, firstNumber_ = 1;
    bool afterReturn_ = false; // a line feed may still belong to it
};

class Checker
{
public:
    explicit Checker(const std::string& file) : file_(file) {}

    // Whether it says anything of geometry.
    bool line(std::string_view line, long long number)
    {
        number_ = number;
        const std::string_view keyword = takeWord(line);
        if (keyword == "v") countNumbers(line, kPosition, 3);
        else if (keyword == "vt") countNumbers(line, kUv, 1);
        else if (keyword == "vn") countNumbers(line, kNormal, 3);
        else if (keyword == "f") face(line);
        else if (keyword == "mtllib") addMaterialFile(line);
        return std::find(kKept.begin(), kKept.end(), keyword) != kKept.end();
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
        long long index = 0, line = 0;
    };

    static constexpr std::array<std::string_view, 7> kKept{"v", "vt", "vn", "f", "usemtl", "g", "o"};

    [[noreturn]] void refuseLine(std::string_view expected) const
    {
        refuse(file_, fmt::format("line {}", number_), expected);
    }

    void addMaterialFile(std::string_view line)
    {
        const std::size_t start = line.find_first_not_of(" \t");
        if (start == line.npos || !known_.emplace(line.substr(start)).second) return;
        if (materialFiles.size() == kMostMaterialFiles)
            refuseLine(fmt::format("expected at most {} material files", kMostMaterialFiles));
        materialFiles.emplace_back(line.substr(start));
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
    long long number_ = 0;
    std::set<std::string, std::less<>> known_; // material files
    std::array<long long, kKinds> counts_{};
    std::array<Most, kKinds> most_{};
};

constexpr std::size_t kBlockBytes = std::size_t(1) << 20;

std::string blockAt(InputBytes& bytes, std::size_t at, const std::string& file)
{
    return bytes.readText(at, std::min(kBlockBytes, bytes.size() - at), file, "expected OBJ text, found a zero byte");
}

// Whether an f stands alone anywhere. Where none does, there are no faces, and gigabytes need not be taken apart to tell.
bool mayHaveFaces(InputBytes& bytes, const std::string& file)
{
    const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\\'; };
    for (std::size_t at = 0; at < bytes.size(); at += kBlockBytes) {
        const std::string block = blockAt(bytes, at, file);
        for (std::size_t f = block.find('f'); f != block.npos; f = block.find('f', f + 1))
            if ((f == 0 || isSpace(block[f - 1])) && (f + 1 == block.size() || isSpace(block[f + 1]))) return true;
    }
    return false;
}

} // namespace

CheckedText checkObj(InputBytes& bytes, const std::string& file)
{
    constexpr std::size_t kLarge = std::size_t(16) << 20;
    if (bytes.size() > kLarge && !mayHaveFaces(bytes, file)) refuse(file, "", "has no triangles");
    CheckedText checked;
    bool isEmpty = true;
    Checker checker(file);
    Lines lines([&](std::string_view line, long long number) {
        isEmpty = false;
        if (checker.line(line, number)) checked.text.append(line) += '\n';
    });
    for (std::size_t at = 0; at < bytes.size(); at += kBlockBytes) {
        const std::string block = blockAt(bytes, at, file);
        std::string_view text = block;
        if (at == 0 && text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
        lines.add(text);
    }
    lines.finish();
    if (isEmpty) refuse(file, "", "is empty");
    checker.finish();
    checked.materialFiles = std::move(checker.materialFiles);
    return checked;
}

} // namespace lixel::obj
