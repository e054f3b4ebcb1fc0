// SPDX-License-Identifier: MIT
#pragma once

#include "comparison.h"

#include <optional>
#include <string>

namespace lixel::app {

// One picture of a built-in scene with all that is known of it, for experiments that look into its values.
struct OnePicture
{
    Shooting shooting;
    Stage stage;
    View view;
    ViewSamples samples;
    Truth truth;

    OnePicture(const std::string& scene, const std::string& viewName, const std::string& size, Executor& executor);
    const Shot& shot() const { return shooting.shots.front(); }
    FramePlan planOf(const std::string& technique, LixelSize lixels, Executor& executor) const;
};

// How many surfaces the rays through the pixels' centres meet between the near and the far plane, one behind the other: the fragments of
// a picture that is drawn without a depth test. Holes do not count.
std::int64_t fragmentsOf(const Stage& stage, const View& view);

} // namespace lixel::app
