// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lixel::obj {

// OBJ text that a parser may read blindly, and the names of its material files.
struct CheckedText
{
    std::string text;                       // continued lines joined, no byte order mark
    std::vector<std::string> materialFiles; // what stands after each mtllib: a name, or several
};

// tinyobjloader reads "nan" as 0, lets large indices wrap and knows no lines; so each line of v, vt, vn and f is judged
// before: numbers finite and up to 1e30, indices within what the file has. Throws InputError with the line.
CheckedText checkObj(std::string_view text, const std::string& file);

} // namespace lixel::obj
