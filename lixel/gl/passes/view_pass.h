// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/view.h"
#include "lixel/gl/device/program.h"
#include "lixel/gl/passes/surfaces.h"
#include "lixel/gl/passes/view_targets.h"

namespace lixel::gl {

// Draws what the view sees: triangle, base colour, shading normal and depth (the G-buffer without positions, which the
// gather pass takes from the triangles).
//   reads   Surfaces        writes   ViewTargets, of the view's size
class ViewPass
{
public:
    static constexpr const char* kName = "view";
    ViewPass();
    void run(const Surfaces& surfaces, const View& view, const ViewTargets& targets) const;

private:
    Program opaque_, masked_;
};

} // namespace lixel::gl
