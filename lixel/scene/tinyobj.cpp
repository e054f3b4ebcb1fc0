// SPDX-License-Identifier: MIT
// tinyobjloader's implementation, compiled here once so that our sanitizers and fuzzers see into it.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
