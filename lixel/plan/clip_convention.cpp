// SPDX-License-Identifier: MIT
#include "lixel/plan/clip_convention.h"

namespace lixel {

Mat4d toHost(const Mat4d& clipFromSource, const ClipConvention& host)
{
    const Vec4d z = clipFromSource.row(2), w = clipFromSource.row(3);
    Mat4d out = clipFromSource;
    if (host.depth == ClipDepth::ZeroToOne) out.setRow(2, 0.5 * (w + z));
    if (host.depth == ClipDepth::OneToZero) out.setRow(2, 0.5 * (w - z));
    if (host.yDown) out.setRow(1, -1.0 * out.row(1));
    return out;
}

Mat4d fromHost(const Mat4d& hostClipFromSource, const ClipConvention& host)
{
    const Vec4d z = hostClipFromSource.row(2), w = hostClipFromSource.row(3);
    Mat4d out = hostClipFromSource;
    if (host.depth == ClipDepth::ZeroToOne) out.setRow(2, 2.0 * z - w);
    if (host.depth == ClipDepth::OneToZero) out.setRow(2, w - 2.0 * z);
    if (host.yDown) out.setRow(1, -1.0 * out.row(1));
    return out;
}

} // namespace lixel
