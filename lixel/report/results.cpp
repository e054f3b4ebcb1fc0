// SPDX-License-Identifier: MIT
#include "lixel/report/results.h"

#include <algorithm>
#include <tuple>

namespace lixel {

void sortByKey(std::vector<ResultRow>& rows)
{
    const auto key = [](const ResultRow& row) {
        return std::tie(row.scene, row.view, row.light, row.techniqueFull, row.lixels, row.size, row.executor,
                        row.seed);
    };
    std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

} // namespace lixel
