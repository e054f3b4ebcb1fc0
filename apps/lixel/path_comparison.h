// SPDX-License-Identifier: MIT
#pragma once

#include "comparison.h"

// Techniques along a path: what compareShot() says of one picture, over all frames, and how many samples flip between them.
namespace lixel::app {

// All rows: techniques x lights x executors. Counts are sums over the frames that the technique served, lixels and bytes those
// of the frame that took most. Footprints are of every n-th sample of n frames, another one in each, so that a path has about
// as many as one picture. Pictures and times are of the frame in the middle. Of the samples no more than two frames' are kept.
std::vector<ResultRow> comparePath(const PathShooting& path, std::span<const std::unique_ptr<Executor>> executors,
                                   const ComparisonOptions& options,
                                   const std::function<void(std::string_view)>& onStep);

// Steps that comparePath() reports.
int stepsOfPath(const PathShooting& path, std::size_t executors, const ComparisonOptions& options);

} // namespace lixel::app
