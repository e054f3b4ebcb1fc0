// SPDX-License-Identifier: MIT
#include "lixel/gl/device/shader_source.h"

#include "generated/shaderTexts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <regex>

namespace lixel::gl {
namespace {

std::string_view trimmed(std::string_view line)
{
    const std::size_t first = line.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view{} : line.substr(first);
}

// What stands behind "#word", or nothing where the line is another.
std::optional<std::string_view> directive(std::string_view line, std::string_view word)
{
    line = trimmed(line);
    if (line.empty() || line.front() != '#') return std::nullopt;
    line = trimmed(line.substr(1));
    if (line.substr(0, word.size()) != word) return std::nullopt;
    return trimmed(line.substr(word.size()));
}

struct Assembly
{
    const ReadShaderFile& read;
    ShaderSource source;
    std::vector<std::size_t> open; // files being appended, outermost first

    // Appends a file behind a guard, since an #include may stand where the preprocessor leaves it out; a file that includes
    // itself again ends there. Replaced lines stay as empty lines, and #line says where text comes from.
    void append(const std::string& path, const std::string& includedFrom)
    {
        const std::optional<std::string_view> text = read(path);
        if (!text) throw ShaderError(fmt::format("{}: there is no shader file \"{}\"", includedFrom, path));
        const std::size_t number = numberOf(path);
        if (std::find(open.begin(), open.end(), number) != open.end()) return;
        open.push_back(number);
        source.text += fmt::format("#ifndef LX_FILE_{0}\n#define LX_FILE_{0}\n#line 1 {0}\n", number);
        int line = 1;
        for (std::size_t at = 0; at < text->size(); ++line) {
            const std::size_t end = std::min(text->find('\n', at), text->size());
            appendLine(text->substr(at, end - at), number, line);
            at = end + 1;
        }
        source.text += "#endif\n";
        open.pop_back();
    }

    std::size_t numberOf(const std::string& path)
    {
        const auto found = std::find(source.files.begin(), source.files.end(), path);
        if (found == source.files.end()) {
            source.files.push_back(path);
            return source.files.size() - 1;
        }
        return std::size_t(found - source.files.begin());
    }

    void appendLine(std::string_view line, std::size_t number, int lineNumber)
    {
        const std::optional<std::string_view> include = directive(line, "include");
        if (include && include->starts_with('"')) {
            const std::size_t end = include->find('"', 1);
            const std::string place = fmt::format("{}:{}", source.files[number], lineNumber);
            if (end == std::string_view::npos) throw ShaderError(place + ": #include without a closing quote");
            append(std::string(include->substr(1, end - 1)), place);
            source.text += fmt::format("#line {} {}\n", lineNumber + 1, number);
        } else if (include || directive(line, "pragma").value_or("").starts_with("once")) {
            source.text += '\n';
        } else {
            source.text += line;
            source.text += '\n';
        }
    }
};

} // namespace

std::optional<std::string_view> readEmbeddedShader(std::string_view path)
{
    for (const EmbeddedText& file : shaderTexts())
        if (file.name == path) return file.text;
    return std::nullopt;
}

ShaderSource assembleShader(const std::string& path, std::span<const std::string> defines, const ReadShaderFile& read)
{
    Assembly assembly{read, {}, {}};
    assembly.source.text = "#version 450 core\n";
    for (const std::string& define : defines) assembly.source.text += fmt::format("#define {}\n", define);
    assembly.append(path, "lixel/gl");
    return std::move(assembly.source);
}

std::string translateLog(const std::string& log, const ShaderSource& source)
{
    // Mesa "0:12(5): error", NVIDIA "0(12) : error", AMD and Intel "ERROR: 0:12: ...".
    static const std::regex place(R"(\b(\d+)(?::(\d+)(?:\(\d+\))?|\((\d+)\)) ?:)");
    std::string out;
    std::size_t at = 0;
    for (std::sregex_iterator match(log.begin(), log.end(), place), end; match != end; ++match) {
        const std::string number = match->str(1), line = match->str(2) + match->str(3);
        const std::size_t file = number.size() < 6 ? std::stoul(number) : source.files.size();
        const auto position = std::size_t(match->position());
        out.append(log, at, position - at);
        out += file < source.files.size() ? fmt::format("{}:{}:", source.files[file], line) : match->str();
        at = position + std::size_t(match->length());
    }
    return out.append(log, at);
}

} // namespace lixel::gl
