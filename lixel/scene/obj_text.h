// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/scene/input_file.h"

#include <string>
#include <vector>

namespace lixel::obj {

// OBJ text that a parser may read blindly, and the names of its material files.
struct CheckedText
{
    std::string text;                       // lines of geometry, continued ones joined
    std::vector<std::string> materialFiles; // what stands after each different mtllib: a name, or several
};

// tinyobjloader reads "nan" as 0, lets large indices wrap and knows no lines; so each line of v, vt, vn and f is judged
// before: numbers finite and up to 1e30, indices within what the file has. Throws InputError with the line, before the rest is read.
CheckedText checkObj(InputBytes& bytes, const std::string& file);

} // namespace lixel::obj
