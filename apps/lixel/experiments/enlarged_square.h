// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/image.h"
#include "lixel/base/surfaces.h"
#include "lixel/base/view_samples.h"
#include "lixel/report/reproduction.h"

#include <span>

namespace lixel::app {

// Enlarges a fifth of the picture's side where an error picture has most that is wrong on planes of interest, where shadows
// are whole: `plane` is of the samples, by planeOfSamples().
void enlargeWhereMostIsWrong(const Image<Rgba8>& errors, const ViewSamples& samples, std::span<const int> plane,
                             PictureRow& figure);

} // namespace lixel::app
