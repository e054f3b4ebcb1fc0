// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

// GLSL for hosts whose casters come through a CasterCallback: they compile it together with their own vertex shader.
namespace lixel {

// The text of lixel_caster.glsl with all it includes, to stand right behind the host's `#version 450 core` (or later). The
// host's main() ends in lixelCaster(positionLocal, uv); its program has the uniform `int lixelFirstView`, which the host sets to
// CasterView::index of the first of the views it draws, one instance a view.
std::string casterVertexText();

// The whole fragment shader. `keep` is empty (opaque), or GLSL with `bool lixelKeep(vec2 uv)` and what that needs, which
// discards where it says false.
std::string casterFragmentText(std::string_view keep = {});

} // namespace lixel
