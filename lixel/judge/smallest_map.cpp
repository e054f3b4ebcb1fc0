// SPDX-License-Identifier: MIT
#include "lixel/judge/smallest_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>

namespace lixel {
namespace {

// A side predicted to be a rung but for this is that rung.
constexpr double kRounding = 1e-9;

constexpr double kStep = 1.02;
constexpr std::size_t kHeld = 3; // sides, the found one among them, at which the tolerance holds

class Search
{
public:
    Search(double tolerancePercent, const std::function<double(int)>& percentAt)
        : tolerance_(tolerancePercent), percentAt_(percentAt)
    {
    }

    SmallestMap from(int firstSide)
    {
        SmallestMap out;
        const std::size_t first = rung(firstSide), next = rung(proportional(first));
        // Two sides tell a line, and one that is already right is asked beside its neighbour, which must be asked anyway.
        const std::size_t second = next != first ? next : first > 0 ? first - 1 : first + 1;
        out.predicted = sides_[rung(onLine(first, second))];
        const auto found = smallestFrom(rung(out.predicted));
        if (found) out.side = sides_[*found];
        out.percent = at(found.value_or(sides_.size() - 1));
        out.measured = int(known_.size());
        return out;
    }

private:
    double proportional(std::size_t i) { return std::isfinite(at(i)) ? sides_[i] * at(i) / tolerance_ : kLargestSide; }

    // Where errors reach the tolerance on the line through two, over 1 / side. Chance may turn the line: then as before.
    double onLine(std::size_t i, std::size_t j)
    {
        const double x = 1.0 / sides_[i], y = 1.0 / sides_[j];
        const double slope = (at(i) - at(j)) / (x - y), least = at(j) - slope * y;
        if (!(slope > 0 && least < tolerance_) || !std::isfinite(slope)) return proportional(j);
        return slope / (tolerance_ - least);
    }

    std::size_t rung(double side) const
    {
        const auto at = std::ranges::lower_bound(sides_, side * (1 - kRounding));
        return at == sides_.end() ? sides_.size() - 1 : std::size_t(at - sides_.begin());
    }

    double at(std::size_t i)
    {
        const auto [place, isNew] = known_.try_emplace(i, 0.0);
        if (isNew) place->second = percentAt_(sides_[i]);
        return place->second;
    }

    bool holdsFrom(std::size_t i)
    {
        for (std::size_t j = i; j < std::min(i + kHeld, sides_.size()); ++j)
            if (!(at(j) <= tolerance_)) return false;
        return true;
    }

    // Steps that double until the answer lies between two sides, then halves.
    std::optional<std::size_t> smallestFrom(std::size_t start)
    {
        std::size_t low = start, high = start, step = 1; // it holds from `high`, not from `low`
        if (holdsFrom(start)) {
            do {
                if (low == 0) return 0;
                high = low;
                low -= std::min(low, step);
                step *= 2;
            } while (holdsFrom(low));
        } else {
            do {
                if (high + 1 == sides_.size()) return std::nullopt;
                low = high;
                high = std::min(high + step, sides_.size() - 1);
                step *= 2;
            } while (!holdsFrom(high));
        }
        while (high - low > 1) {
            const std::size_t middle = (low + high) / 2;
            (holdsFrom(middle) ? high : low) = middle;
        }
        return high;
    }

    double tolerance_;
    const std::function<double(int)>& percentAt_;
    std::vector<int> sides_ = ladderOfSides();
    std::map<std::size_t, double> known_;
};

} // namespace

std::vector<int> ladderOfSides()
{
    std::vector<int> out;
    for (double side = kSmallestSide; side < kLargestSide; side *= kStep)
        if (out.empty() || std::lround(side) > out.back()) out.push_back(int(std::lround(side)));
    if (out.back() < kLargestSide) out.push_back(kLargestSide);
    return out;
}

SmallestMap smallestMap(double tolerancePercent, int firstSide, const std::function<double(int)>& percentAt)
{
    return Search(tolerancePercent, percentAt).from(firstSide);
}

} // namespace lixel
