// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace lixel::test {

// What docs/results.schema.json forbids in the JSON text, a line for each place; empty when it is valid.
std::string schemaError(const std::string& text);

// The same by another schema of docs/, by its file's name.
std::string schemaError(const std::string& text, const std::string& schemaFile);

} // namespace lixel::test
