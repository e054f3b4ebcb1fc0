// SPDX-License-Identifier: MIT
#pragma once

// LX_ASSERT states what only a mistake of ours can break; it holds in every build, since a wrong shadow told as right is
// worse than a stop.
namespace lixel {
[[noreturn]] void assertionFailed(const char* condition, const char* file, int line);
}

#define LX_ASSERT(condition) ((condition) ? void(0) : ::lixel::assertionFailed(#condition, __FILE__, __LINE__))
