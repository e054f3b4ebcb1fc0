// SPDX-License-Identifier: MIT
#include "lixel/base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace lixel {

void assertionFailed(const char* condition, const char* file, int line)
{
    std::fprintf(stderr, "lixel: a mistake in lixel itself: %s does not hold (%s:%d)\n", condition, file, line);
    std::abort();
}

} // namespace lixel
