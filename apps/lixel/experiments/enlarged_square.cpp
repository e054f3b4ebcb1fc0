// SPDX-License-Identifier: MIT
#include "experiments/enlarged_square.h"

#include "lixel/judge/on_planes.h"

#include <algorithm>

namespace lixel::app {
namespace {

constexpr double kEnlargedShare = 0.2; // of the picture's side

} // namespace

void enlargeWhereMostIsWrong(const Image<Rgba8>& errors, const ViewSamples& samples, std::span<const int> plane,
                             PictureRow& figure)
{
    figure.side = std::max(1, int(kEnlargedShare * std::min(errors.width(), errors.height())));
    const int step = std::max(1, figure.side / 4);
    const int columns = errors.width() / step + 1, rows = errors.height() / step + 1;
    Image<int> wrong(columns, rows, 0); // from each place for a square, a step apart
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const int x = int(samples.pixel[i].x), y = errors.height() - 1 - int(samples.pixel[i].y); // from the top
        if (plane[i] == kOnNoPlane || errors(x, errors.height() - 1 - y).a == 0) continue;
        for (int row = y < figure.side ? 0 : (y - figure.side) / step + 1; row * step <= y; ++row)
            for (int column = x < figure.side ? 0 : (x - figure.side) / step + 1; column * step <= x; ++column)
                ++wrong(column, row);
    }
    int most = -1;
    for (int row = 0; row * step + figure.side <= errors.height(); ++row)
        for (int column = 0; column * step + figure.side <= errors.width(); ++column)
            if (wrong(column, row) > most)
                most = wrong(column, row), figure.left = column * step, figure.top = row * step;
}

} // namespace lixel::app
