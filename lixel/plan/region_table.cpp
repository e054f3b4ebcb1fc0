// SPDX-License-Identifier: MIT
#include "lixel/plan/region_table.h"

#include "lixel/plan/clip_convention.h"

namespace lixel {

shared::ShadowRegion tableRow(const PlannedRegion& region)
{
    const LixelRectangle& r = region.rectangle;
    shared::ShadowRegion row;
    const Mat4d clip = toHost(region.lightClipFromLocal, kExecutorConvention);
    Mat4d low;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) low.m[i][j] = clip.m[i][j] - double(float(clip.m[i][j]));
    row.lightClipFromLocal = toShared(clip);
    row.lightClipLow = toShared(low);
    row.lixelFromNdc = {0.5f * float(r.width()), 0.5f * float(r.height()), float(r.x0) + 0.5f * float(r.width()),
                        float(r.y0) + 0.5f * float(r.height())};
    row.rectangle = {float(r.x0), float(r.y0), float(r.x1), float(r.y1)};
    row.place = {float(r.layer), 0, 0, region.isInDouble ? 1.0f : 0.0f};
    return row;
}

} // namespace lixel
