// SPDX-License-Identifier: MIT
#include "experiment.h"

#include <array>

namespace lixel::app {

std::span<const Experiment> experiments()
{
    static const std::array<Experiment, 1> kAll{{
        {"normal-against-focused",
         "H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, Table 1 (columns Focused and Normal)",
         "How many more samples does a map of the whole scene get wrong than one focused on the view?",
         reproduceNormalAgainstFocused},
    }};
    return kAll;
}

} // namespace lixel::app
