// SPDX-License-Identifier: MIT
// For vertex shaders that draw casters into shadow maps, lixel's own and a host's alike: they end in
//
//   lixelCaster(positionLocal, uv);
//
// Each caster is drawn instanced, one instance a view: instance i goes into region lixelFirstView + i of the plan, which is
// CasterView::index of the first view meant. A host that has instances of its own calls lixelCasterInto() instead. Taken here:
// output location 0, shader storage binding kStorageRegions, uniform binding kUniformBatch (lixel/shared/gl_slots.h).
#extension GL_ARB_shader_viewport_layer_array : require
#include "lixel/shared/gl_slots.h"
#include "lixel/shared/light_clip.h"

layout(std430, binding = kStorageRegions) readonly buffer LixelRegions { ShadowRegion lixelRegions[]; };
layout(std140, binding = kUniformBatch) uniform LixelBatch { vec4 lixelBatch; }; // x: the region that has viewport 0

uniform int lixelFirstView;

layout(location = 0) out vec2 lixelUv;

// Into one region of the plan, by its index.
void lixelCasterInto(int view, vec3 positionLocal, vec2 uv)
{
    lixelUv = uv;
    gl_ViewportIndex = view - int(lixelBatch.x);
    gl_Layer = int(lixelRegions[view].place.x);
    gl_Position = lxLightClip(lixelRegions[view], positionLocal);
}

void lixelCaster(vec3 positionLocal, vec2 uv) { lixelCasterInto(lixelFirstView + gl_InstanceID, positionLocal, uv); }
