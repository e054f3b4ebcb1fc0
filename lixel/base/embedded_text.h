// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/assert.h"

#include <span>
#include <string_view>

namespace lixel {

// A text file that was built into the program by lixel_embed_text() of cmake/embed_text.cmake.
struct EmbeddedText
{
    std::string_view name; // its path below the folder given there, with forward slashes
    std::string_view text;
};

// The text of that name, or nullptr.
inline const EmbeddedText* findText(std::span<const EmbeddedText> texts, std::string_view name)
{
    for (const EmbeddedText& text : texts)
        if (text.name == name) return &text;
    return nullptr;
}

// The text of that name, which must be there.
inline std::string_view textNamed(std::span<const EmbeddedText> texts, std::string_view name)
{
    const EmbeddedText* found = findText(texts, name);
    LX_ASSERT(found != nullptr);
    return found->text;
}

} // namespace lixel
