// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace lixel::test {

// What docs/results.schema.json forbids in the JSON text, a line for each place; empty when it is valid.
std::string schemaError(const std::string& text);

} // namespace lixel::test
