// SPDX-License-Identifier: MIT
#include "lixel/plan/allocate.h"

#include "lixel/base/fixed_vector.h"
#include "lixel/plan/footprint.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lixel {
namespace {

constexpr std::size_t kMostSamples = 512;
constexpr std::size_t kMostRectangles = 64;
constexpr double kLeastOfEvenShare = 1.0 / 32;

std::int64_t lixelsOf(const LixelRectangle& r) { return std::int64_t(r.width()) * r.height(); }

} // namespace

double needOf(const Fit& fit, const View& view, Vec3d originWorld, std::span<const Vec3d> seenLocal,
              std::span<const Vec3d> seenNormal)
{
    if (seenLocal.empty()) return 0;
    const LightImage image(fit.lightClipFromLocal, {0, 0, 1, 1, 0});
    const std::size_t step = std::max<std::size_t>(1, seenLocal.size() / kMostSamples);
    // Edge-on surfaces have endless lixels; no lixel matters beyond the whole picture.
    const double most = std::hypot(view.width, view.height);
    double sum = 0;
    std::size_t taken = 0;
    for (std::size_t i = step / 2; i < seenLocal.size(); i += step) {
        ++taken;
        if (const auto f = footprint(view, originWorld, image, seenLocal[i], seenNormal[i]))
            sum += std::min(f->pixelsPerLixel, 64 * most);
    }
    return taken > 0 ? sum * double(seenLocal.size()) / double(taken) : 0;
}

void sharesByNeed(std::span<double> needs)
{
    const double even = 1.0 / double(needs.size());
    double sum = 0;
    for (double& need : needs) sum += need = std::cbrt(need * need);
    if (!(sum > 0) || !std::isfinite(sum)) {
        std::fill(needs.begin(), needs.end(), even);
        return;
    }
    double total = 0;
    for (double& need : needs) total += need = std::max(need / sum, kLeastOfEvenShare * even);
    for (double& need : needs) need /= total;
}

bool cutRectangle(LixelRectangle whole, std::span<const double> shares, std::span<LixelRectangle> pieces)
{
    LX_ASSERT(shares.size() == pieces.size() && !shares.empty());
    if (lixelsOf(whole) < std::int64_t(shares.size())) return false;
    if (shares.size() == 1) {
        pieces[0] = whole;
        return true;
    }
    // Where the sum of shares comes nearest to a half.
    const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
    std::size_t first = 0;
    double before = 0;
    while (first + 1 < shares.size() && (first == 0 || before + 0.5 * shares[first] < 0.5 * total))
        before += shares[first++];

    const bool acrossX = whole.width() >= whole.height();
    const int length = acrossX ? whole.width() : whole.height(), breadth = acrossX ? whole.height() : whole.width();
    // Each part keeps room for its pieces; where lixels are so few that it cannot, pieces go to the other part.
    const auto slabs = [breadth](std::size_t count) {
        return int((count + std::size_t(breadth) - 1) / std::size_t(breadth));
    };
    const auto count = int(shares.size());
    const int least = std::min(slabs(first), length - 1), most = length - slabs(shares.size() - first);
    const double share = total > 0 ? before / total : 0.5;
    const int at = std::clamp(int(std::lround(share * length)), least, std::max(least, most));
    const double room = double(at) * breadth, roomOfOther = double(length - at) * breadth;
    first = std::size_t(std::clamp(double(first), count - roomOfOther, room));
    LixelRectangle one = whole, other = whole;
    if (acrossX) one.x1 = other.x0 = whole.x0 + at;
    else one.y1 = other.y0 = whole.y0 + at;
    return cutRectangle(one, shares.subspan(0, first), pieces.subspan(0, first)) &&
           cutRectangle(other, shares.subspan(first), pieces.subspan(first));
}

LixelSize packRectangles(std::span<const LixelSize> sizes, int layer, std::span<LixelRectangle> rectangles)
{
    LX_ASSERT(sizes.size() == rectangles.size() && sizes.size() <= kMostRectangles);
    FixedVector<std::size_t, kMostRectangles> order;
    double area = 0;
    int width = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        order.push_back(i);
        area += double(sizes[i].width) * sizes[i].height;
        width = std::max(width, sizes[i].width);
    }
    width = std::max(width, int(std::ceil(std::sqrt(area))));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return sizes[a].height != sizes[b].height ? sizes[a].height > sizes[b].height : a < b;
    });
    LixelSize used;
    int x = 0, y = 0, shelf = 0;
    for (const std::size_t i : order) {
        if (x > 0 && x + sizes[i].width > width) {
            x = 0;
            y += shelf;
        }
        if (x == 0) shelf = sizes[i].height;
        rectangles[i] = {x, y, x + sizes[i].width, y + sizes[i].height, layer};
        x += sizes[i].width;
        used = {std::max(used.width, x), std::max(used.height, y + shelf)};
    }
    return used;
}

} // namespace lixel
