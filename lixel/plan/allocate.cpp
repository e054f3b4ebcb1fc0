// SPDX-License-Identifier: MIT
#include "lixel/plan/allocate.h"

#include "lixel/base/fixed_vector.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lixel {
namespace {

constexpr std::size_t kMostRectangles = 64;
constexpr std::size_t kMostTried = 8; // pieces for which all ways to halve are tried
constexpr double kLeastOfEvenShare = 1.0 / 32;

// A map is turned, or a rectangle cut along its shorter side, for no less than this: what is all but the same either way would turn and
// turn back as samples change.
constexpr double kWorthTurning = 0.97;

std::int64_t lixelsOf(const LixelRectangle& r) { return std::int64_t(r.width()) * r.height(); }

// A rectangle in two, where the sum of shares comes nearest to a half.
struct Halves
{
    LixelRectangle one, other;
    std::size_t count = 0; // pieces in the first
};

Halves halved(LixelRectangle whole, std::span<const double> shares, bool acrossX)
{
    const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
    std::size_t first = 0;
    double before = 0;
    while (first + 1 < shares.size() && (first == 0 || before + 0.5 * shares[first] < 0.5 * total))
        before += shares[first++];

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
    Halves halves{whole, whole, first};
    if (acrossX) halves.one.x1 = halves.other.x0 = whole.x0 + at;
    else halves.one.y1 = halves.other.y0 = whole.y0 + at;
    return halves;
}

// Regions whose rectangles are looked for.
struct Wanting
{
    std::span<const double> shares;
    std::span<const Need> needs;
    double reach;

    std::size_t size() const { return shares.size(); }
    Wanting first(std::size_t n) const { return {shares.first(n), needs.first(n), reach}; }
    Wanting after(std::size_t n) const { return {shares.subspan(n), needs.subspan(n), reach}; }
};

// What place() leaves of a side.
double withinBand(int lixels, double reach) { return std::max(lixels - 2 * reach, 0.5); }

// The pieces with the least predicted error, which is returned.
double leastError(LixelRectangle whole, const Wanting& wanting, std::span<LixelRectangle> pieces,
                  std::span<bool> turned)
{
    if (wanting.size() == 1) {
        const double width = withinBand(whole.width(), wanting.reach),
                     height = withinBand(whole.height(), wanting.reach);
        const double upright = wanting.needs[0].within(width, height), across = wanting.needs[0].within(height, width);
        pieces[0] = whole;
        turned[0] = across < kWorthTurning * upright;
        return turned[0] ? across : upright;
    }
    const auto cutAcross = [&](bool acrossX) {
        const Halves halves = halved(whole, wanting.shares, acrossX);
        const std::size_t n = halves.count;
        return leastError(halves.one, wanting.first(n), pieces.first(n), turned.first(n)) +
               leastError(halves.other, wanting.after(n), pieces.subspan(n), turned.subspan(n));
    };
    if (wanting.size() > kMostTried || std::min(whole.width(), whole.height()) < 2)
        return cutAcross(whole.width() >= whole.height());
    const double alongX = cutAcross(true);
    FixedVector<LixelRectangle, kMostTried> piecesAlongX;
    FixedVector<bool, kMostTried> turnedAlongX;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        piecesAlongX.push_back(pieces[i]), turnedAlongX.push_back(turned[i]);
    const double alongY = cutAcross(false);
    const bool isWide = whole.width() > whole.height();
    if (isWide ? alongY < kWorthTurning * alongX : !(alongX < kWorthTurning * alongY)) return alongY;
    std::copy(piecesAlongX.begin(), piecesAlongX.end(), pieces.begin());
    std::copy(turnedAlongX.begin(), turnedAlongX.end(), turned.begin());
    return alongX;
}

} // namespace

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
    const Halves halves = halved(whole, shares, whole.width() >= whole.height());
    return cutRectangle(halves.one, shares.first(halves.count), pieces.first(halves.count)) &&
           cutRectangle(halves.other, shares.subspan(halves.count), pieces.subspan(halves.count));
}

bool cutRectangleByNeed(LixelRectangle whole, std::span<const double> shares, std::span<const Need> needs,
                        std::span<LixelRectangle> pieces, std::span<bool> turned, double reach)
{
    LX_ASSERT(shares.size() == pieces.size() && needs.size() == pieces.size() && turned.size() == pieces.size());
    LX_ASSERT(!pieces.empty() && pieces.size() <= kMostRectangles);
    if (lixelsOf(whole) < std::int64_t(shares.size())) return false;
    const double error = leastError(whole, {shares, needs, reach}, pieces, turned);
    // Halving may miss what even shares reach.
    FixedVector<double, kMostRectangles> even;
    FixedVector<LixelRectangle, kMostRectangles> evenPieces;
    FixedVector<bool, kMostRectangles> evenTurned;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        even.push_back(1.0 / double(pieces.size())), evenPieces.push_back({}), evenTurned.push_back(false);
    const Wanting evenly{{even.data(), even.size()}, needs, reach};
    if (leastError(whole, evenly, {evenPieces.data(), evenPieces.size()}, {evenTurned.data(), evenTurned.size()}) <
        error) {
        std::copy(evenPieces.begin(), evenPieces.end(), pieces.begin());
        std::copy(evenTurned.begin(), evenTurned.end(), turned.begin());
    }
    return true;
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
