// SPDX-License-Identifier: MIT
#include "lixel/gl/passes/visibility_list.h"

#include "lixel/base/assert.h"
#include "lixel/shared/gl_slots.h"

#include <algorithm>

namespace lixel::gl {

void VisibilityList::resize(const PointList& points, std::size_t lights)
{
    size_ = points.size();
    lights_ = lights;
    parts_ = points.parts(sizeof(float) * lights);
    values_.reserve(sizeof(float) * lights * size_);
}

void VisibilityList::upload(std::span<const std::vector<float>> values)
{
    LX_ASSERT(values.size() == lights_);
    for (const Part& part : parts_)
        for (std::size_t light = 0; light < lights_; ++light) {
            LX_ASSERT(values[light].size() == size_);
            values_.write(offset(light, part), std::span<const float>(values[light]).subspan(part.first, part.count));
        }
}

std::vector<Visibility> VisibilityList::download() const
{
    std::vector<Visibility> lights(lights_);
    for (std::size_t light = 0; light < lights_; ++light) {
        Visibility& visibility = lights[light];
        visibility.value.resize(size_);
        visibility.unserved.assign(size_, 0);
        for (const Part& part : parts_)
            values_.read(offset(light, part), std::span<float>(visibility.value).subspan(part.first, part.count));
        for (std::size_t i = 0; i < size_; ++i)
            if (visibility.value[i] < 0) visibility.value[i] = 1, visibility.unserved[i] = 1;
    }
    return lights;
}

void VisibilityList::bind(const Part& part) const
{
    // Without lights there is nothing to see, but a binding must not be empty.
    const std::size_t bytes = sizeof(float) * std::max<std::size_t>(lights_ * part.count, 1);
    values_.bindStorage(shared::kStorageVisibility, offset(0, part), bytes);
}

} // namespace lixel::gl
