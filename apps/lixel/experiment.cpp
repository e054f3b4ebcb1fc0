// SPDX-License-Identifier: MIT
#include "experiment.h"

#include <array>

namespace lixel::app {

std::span<const Experiment> experiments()
{
    static const std::array<Experiment, 12> kAll{{
        {"normal-against-focused",
         "H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, Table 1 (columns Focused and Normal)",
         "How many more samples does a map of the whole scene get wrong than one focused on the view?", "gl", true,
         reproduceNormalAgainstFocused},
        {"lixel-fig7",
         "H. Chong, S. Gortler. A Lixel for every Pixel. Eurographics Symposium on Rendering 2004, section 4 and "
         "Figure 7",
         "What do maps for planes of interest show, with as many lixels, where conventional and perspective maps fail?",
         "gl", false, reproduceLixelFig7},
        {"scene-optimised-table1",
         "H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, section 3, Table 1 and "
         "Figures 2 and 4",
         "How many samples does each way to choose the light's matrix get wrong, over lights from everywhere above?",
         "trace", true, reproduceSceneOptimisedTable1},
        {"scene-optimised-table2",
         "H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, Table 2 and sections 2.4 and 3",
         "What does a frame cost with scene-optimised maps, by lights and lixels, against focused ones of the same "
         "run?",
         "gl", false, reproduceSceneOptimisedTable2},
        {"scene-optimised-table3", "H. Chong, S. Gortler. Scene Optimized Shadow Mapping. 2007, Table 3",
         "Where does the time of a frame with scene-optimised maps go?", "gl", false, reproduceSceneOptimisedTable3},
        {"multiple-depth-table1",
         "C. Pagot, J. Comba, M. Oliveira. Multiple-Depth Shadow Maps. SIBGRAPI 2004, Table 1 and Figure 3",
         "How many shades do n depths a lixel and k taps give in pictures, of the nk + 1 that there can be?", "gl",
         false, reproduceMultipleDepthTable1},
        {"multiple-depth-figures",
         "C. Pagot, J. Comba, M. Oliveira. Multiple-Depth Shadow Maps. SIBGRAPI 2004, Figures 1, 6 and 7",
         "Are the shadows of several depths and small kernels as good as those of one depth and a larger kernel?", "gl",
         false, reproduceMultipleDepthFigures},
        {"multiple-depth-cost",
         "C. Pagot, J. Comba, M. Oliveira. Multiple-Depth Shadow Maps. SIBGRAPI 2004, equations 1 to 6",
         "From how many fragments a lixel on are several depths cheaper than a larger kernel?", "gl", false,
         reproduceMultipleDepthCost},
        {"now-table1",
         "T. Milet, J. Navratil, P. Zemcik. An Improved Non-Orthogonal Texture Warping for Better Shadow Rendering. "
         "2015, Table 1 and the teaser",
         "What does a frame cost with each way to make a map, outdoors, and how much of it is wrong?", "gl", false,
         reproduceNowTable1},
        {"now-table2", "Milet et al. 2015, Table 2", "Where does the time of warped maps go?", "gl", false,
         reproduceNowTable2},
        {"now-table3", "Milet et al. 2015, Table 3 and Figure 7",
         "What do warped maps cost and what do they get wrong in rooms and outdoors?", "gl", false, reproduceNowTable3},
        {"now-figures", "Milet et al. 2015, the teaser, Figures 4 to 7, and section 4 on the minimal shadow frustum",
         "What do warps do to a map, and do they gain more, the more of the scene is visible?", "trace", false,
         reproduceNowFigures},
    }};
    return kAll;
}

} // namespace lixel::app
