// SPDX-License-Identifier: MIT
// For vertex shaders that draw casters into shadow maps, lixel's own and a host's alike: they end in
//
//   lixelCaster(positionLocal, uv);
//
// Each caster is drawn instanced, one instance a view: instance i goes into region lixelFirstView + i of the plan, which is
// CasterView::index of the first view meant. A host that has instances of its own calls lixelCasterInto() instead. Taken here:
// output locations 0, 4 and 5, shader storage bindings kStorageRegions and kStorageWarps, uniform binding kUniformBatch
// (lixel/shared/gl_slots.h). A host without warps and paraboloids may define LIXEL_NO_WARP before; LIXEL_TESSELLATE is lixel's own, where
// caster.tesc.glsl and caster.tese.glsl follow.
#ifdef LIXEL_TESSELLATE
#include "lixel/shared/gl_slots.h"
layout(location = 4) out vec3 lixelPosition;
layout(location = 5) out int lixelView;
#else
#include "lixel/gl/shaders/place_caster.glsl"
#endif

uniform int lixelFirstView;

layout(location = 0) out vec2 lixelUv;

// Into one region of the plan, by its index.
void lixelCasterInto(int view, vec3 positionLocal, vec2 uv)
{
    lixelUv = uv;
#ifdef LIXEL_TESSELLATE
    lixelPosition = positionLocal;
    lixelView = view;
#else
    lixelPlace(view, positionLocal);
#endif
}

void lixelCaster(vec3 positionLocal, vec2 uv) { lixelCasterInto(lixelFirstView + gl_InstanceID, positionLocal, uv); }
