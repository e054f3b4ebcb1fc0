// SPDX-License-Identifier: MIT
// The materials of the surfaces and which of them each triangle, in drawing order, has.
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/view_tables.h"

layout(std430, binding = kStorageMaterials) readonly buffer Materials { SurfaceMaterial materials[]; };
layout(std430, binding = kStorageTriangleMaterial) readonly buffer TriangleMaterial { uint triangleMaterial[]; };
