// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/base/caster_source.h"
#include "lixel/base/light.h"
#include "lixel/base/mat4.h"
#include "lixel/base/view_samples.h"
#include "support/random_cases.h"

#include <vector>

// Small bodies for tests of rays: made in double in world space, placed, rounded to floats once.
namespace lixel::test {

struct Shape
{
    std::vector<Vec3d> corner;
    std::vector<std::uint32_t> indices;
};

Shape gridPlane(int cells, double half); // y = 0, within +-half
Shape sphere(int slices, int stacks, double radius);
Shape box(Vec3d low, Vec3d high, int cells = 1); // each side cells x cells squares
Shape cylinder(int sides, int rings, double radius, double height);

Shape placed(const Mat4d& worldFromShape, Shape shape);
Shape joined(Shape first, const Shape& second); // the second's triangles follow the first's
LocalTriangles triangles(const Shape& shapeWorld, Vec3d originWorld = {});

// Any turn, from three random angles.
Mat4d anyRotation(Rng& rng);

// A light of any kind about `centreWorld`, at a distance of that many `radius`.
Light anyLight(Rng& rng, Vec3d centreWorld, double radius);

// One sample on a random point of each of `count` random triangles, both sides.
ViewSamples anySamplesOn(const LocalTriangles& casters, std::size_t firstTriangle, std::size_t endTriangle, int count,
                         Rng& rng);

// Appends one sample; the normal is the triangle's, turned to the side of `towards`.
void addSample(ViewSamples& samples, const LocalTriangles& casters, std::uint32_t triangle, Vec3d pointLocal,
               Vec3d towards);

} // namespace lixel::test
