// SPDX-License-Identifier: MIT
#include "lixel/plan/host_region.h"

#include "lixel/base/assert.h"

namespace lixel {

HostRegion toHost(const PlannedRegion& region, LixelSize atlas, const ClipConvention& host, TextureOrigin origin)
{
    LX_ASSERT(!region.paraboloid);
    HostRegion out{toHost(region.lightClipFromLocal, host), region.rectangle, {}};
    if (origin == TextureOrigin::Top) {
        out.viewport.y0 = atlas.height - region.rectangle.y1;
        out.viewport.y1 = atlas.height - region.rectangle.y0;
    }

    // (u, v) is affine in NDC: with x = X / w, u = scale x + offset is row scale X + offset w.
    const LixelRectangle& r = out.viewport;
    const Mat4d& clip = region.lightClipFromLocal;
    const double turn = origin == TextureOrigin::Top ? -1 : 1;
    const Vec4d w = clip.row(3);
    out.textureFromLocal.setRow(0, 0.5 * r.width() / atlas.width * clip.row(0) + 0.5 * (r.x0 + r.x1) / atlas.width * w);
    out.textureFromLocal.setRow(1, turn * 0.5 * r.height() / atlas.height * clip.row(1) +
                                       0.5 * (r.y0 + r.y1) / atlas.height * w);
    // OpenGL's depth buffer holds 0..1 in either depth convention.
    const ClipDepth stored = host.depth == ClipDepth::MinusOneToOne ? ClipDepth::ZeroToOne : host.depth;
    out.textureFromLocal.setRow(2, toHost(clip, ClipConvention{stored, false}).row(2));
    out.textureFromLocal.setRow(3, w);
    return out;
}

Vec2d toHost(Vec2d lixel, LixelSize atlas, TextureOrigin origin)
{
    return {lixel.x, origin == TextureOrigin::Top ? atlas.height - lixel.y : lixel.y};
}

} // namespace lixel
