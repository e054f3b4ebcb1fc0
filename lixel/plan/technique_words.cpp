// SPDX-License-Identifier: MIT
#include "lixel/plan/technique.h"

#include <array>

namespace lixel {
namespace {

constexpr std::string_view kAnyLight = "directional, spot, point";

constexpr std::array<TechniqueWord, 36> kWords{{
    {"partition", "whole", "one region: all of space", "", "all", ""},
    {"partition", "pssm(n, lambda=0.5, stable)",
     "n = 1 to 16 regions along the line of sight, split between evenly (0) and logarithmically (1)",
     "Zhang, Sun, Xu, Lun 2006", "all", "nothing-in-view"},
    {"partition", "sdsm(n, stable)", "n regions along the line of sight, split logarithmically between seen depths",
     "Lauritzen, Salvi, Lefohn 2011", "all", "no-view-samples, nothing-in-view"},
    {"partition", "cube", "the faces of a cube around the light that something is seen in", "Greene 1986",
     "spot, point; directional lights have one region", ""},
    {"partition", "dual-paraboloid(raster=exact/tessellate/vertices)",
     "two half spheres of light rays, each on a paraboloid; how casters get into those maps, where a warp does not say "
     "it",
     "Brabec, Annen, Seidel 2002", "spot, point", "no-place-of-light, nothing-in-view"},
    {"partition", "planes(name, ..., twist=tight/none/line)",
     "the light rays that meet each of some planes of the scene, in this order; planes(auto) finds them in what is "
     "seen",
     "Chong, Gortler 2004", "all", "no-such-plane; planes(auto): no-view-samples"},
    {"fit", "uniform", "the whole scene, whatever the view sees (the papers' \"normal\" map)", "Williams 1978",
     kAnyLight, "extent-not-in-hemisphere, nothing-in-view"},
    {"fit", "focused(stable)",
     "view frustum, scene bounds and the light's cone clipped against each other, in the rectangle of least area",
     "Brabec, Annen, Seidel 2002; Chong, Gortler 2007 (Focused)", kAnyLight,
     "extent-not-in-hemisphere, nothing-in-view"},
    {"fit", "desired-view(rotated)", "the view samples' own rectangle, upright or of least area",
     "Rosen 2012; Milet 2015 (DV)", kAnyLight, "no-view-samples, extent-not-in-hemisphere, nothing-in-view"},
    {"fit", "minimal-frustum", "focused, with near and far cut tight to casters and receivers",
     "Stamminger, Drettakis 2002; Milet 2015 (MIN-SM)", kAnyLight, "extent-not-in-hemisphere, nothing-in-view"},
    {"fit", "psm(shift=casters/none)",
     "as the light sees the scene after the view's perspective; its camera moved back before all casters, or not",
     "Stamminger, Drettakis 2002; Kozlov 2004", kAnyLight, "extent-not-in-hemisphere, nothing-in-view"},
    {"fit", "tsm(focus=depth)",
     "the trapezoid around what is seen, nearer than the focus depth on 80 % of the map (the middle depth, if not "
     "given)",
     "Martin, Tan 2004", kAnyLight, "extent-not-in-hemisphere, nothing-in-view"},
    {"fit", "lispsm(stable)", "a perspective across the light as strong as makes near and far errors equal",
     "Wimmer, Scherzer, Purgathofer 2004", kAnyLight, "extent-not-in-hemisphere, nothing-in-view"},
    {"fit", "plane-optimal(desired-view, uncovered=lit)",
     "of a region's plane every pixel has its lixel; what no plane holds goes to else(...), focused if not given",
     "Chong, Gortler 2004", kAnyLight, "plane-faces-away, light-in-plane, eye-in-plane, nothing-in-view"},
    {"fit",
     "scene-optimal(metric=width/l2/lloyd/area, search=wide/paper, holds=seen/shadows, iterations=, shear, slack=, "
     "weight=, samples=, "
     "keep=, update=, uncovered=lit)",
     "the matrix that is best for what is seen near the edges of shadows; what it does not hold goes to else(...), "
     "focused if not "
     "given",
     "Chong, Gortler 2007", kAnyLight, "no-view-samples, extent-not-in-hemisphere, nothing-in-view"},
    {"fit", "matrix(file)", "another engine's matrix for each light", "", kAnyLight, "not-given"},
    {"fit", "plan(file)", "another engine's regions, rectangles and matrices", "", kAnyLight, "not-given"},
    {"fallback", "else(partition+fit)", "serves what falls out of all regions; its lixels count", "", "all", ""},
    {"allocation", "allocation=need/share/exact",
     "lixels of several regions: so that the predicted error is least, the same number for each, or for planes a lixel "
     "a pixel",
     "", "all", "too-few-lixels"},
    {"warp",
     "rtw(importance=, analysis=backward/forward/hybrid, power=, smooth=, floor=, grid=, "
     "raster=exact/tessellate/vertices)",
     "lixels moved along x and y to where importance is greatest in their columns and rows; importance= count, "
     "distance, normal, edges, boundaries, shadow-edges, max(...) of some, products by *",
     "Rosen 2012", "all", ""},
    {"warp", "now(as rtw, lines=interpolated/nearest)",
     "every row moved by a function of its own, then every column: lixels serve like numbers of samples, to a power",
     "Milet, Navratil, Zemcik 2015", "all", ""},
    {"store", "depths(n, max/min/minmax/sorted, q=9/25, bits=16/32)",
     "n depths a lixel: its own, and of the q lixels around the farthest, the nearest (n = 2), both (3), or one of "
     "each "
     "of n groups (4 to 8); more than four have 16 bits",
     "Williams 1978; Pagot, Comba, Oliveira 2004", "all", ""},
    {"store", "fast-pcf", "the depths of four neighbouring lixels, of 8 bits each", "Brabec, Seidel 2001", "all", ""},
    {"store", "vsm(blur=3)", "two moments of the depths around a lixel, averaged over blur x blur lixels",
     "Donnelly, Lauritzen 2006", "all", ""},
    {"store", "evsm2(blur=3)", "the same of an exponential of depth", "Lauritzen, McCool 2008", "all", ""},
    {"store", "evsm4(blur=3)", "the same of two exponentials", "Lauritzen, McCool 2008", "all", ""},
    {"store", "msm(blur=3)", "four moments of depth", "Peters, Klein 2015", "all", ""},
    {"kernel", "pcf(k, rotated/jittered)",
     "k = 1, 4, 9, 16, 25 taps one lixel apart, results averaged; the grid turned, or each tap moved, for each sample",
     "Reeves, Salesin, Cook 1987", "all", ""},
    {"kernel", "bilinear", "the four lixels around by their areas, rounded to lit or shadow", "", "all", ""},
    {"kernel", "hardware-pcf", "the same not rounded, by the texture unit, against one depth", "", "all", ""},
    {"refinement", "dual-plane", "in shadow only behind the plane of the surface that is stored, too", "", "all", ""},
    {"no map", "exact", "a ray for every view sample, decided in double precision", "", "all", ""},
    {"no map", "exact-area(n)", "share of the pixel's area that is lit; n = 1, 4, ..., 1024 rays a pixel", "", "all",
     ""},
    {"no map", "exact-filtered(technique, rays=256)",
     "share of the square of lixels that the technique's lookup averages over that is lit, on the sample's plane: what "
     "its filter "
     "stands for; rays = 1, 4, ..., 1024 a sample",
     "", "those of the technique", "whatever the technique refuses; bilinear, which is rounded"},
    {"no map", "shadow-volumes", "volumes from silhouettes, counted in the stencil behind what is seen; with gl only",
     "Crow 1977; Everitt, Kilgard 2002; Kim et al. 2008", "all", "masked-casters, parallel-view"},
    {"preset", "paper:rtw, now, now-dv, min-sm",
     "a technique as its paper has it, alone or with further words: RTW, Ours, Ours-DV and MIN-SM of Milet et al.",
     "Rosen 2012; Milet, Navratil, Zemcik 2015", "all", "no-view-samples"},
}};

} // namespace

std::span<const TechniqueWord> techniqueWords() { return kWords; }

} // namespace lixel
