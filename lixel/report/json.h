// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/report/results.h"

#include <string>

namespace lixel {

// Of docs/results.schema.json; raised by every change that could break a reader.
inline constexpr int kResultsVersion = 1;

// The run as JSON, valid by docs/results.schema.json and closed by a line break. Rows and keys are sorted and numbers
// are the shortest that read back as the same value: equal results give equal bytes. Numbers that are not finite become
// null, bytes that are not UTF-8 the replacement character.
std::string toJson(const RunResults& results);

// One row as `results` there has it, in one line without a break.
std::string toJson(const ResultRow& row, const std::string& lixelVersion);

} // namespace lixel
