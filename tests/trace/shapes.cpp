// SPDX-License-Identifier: MIT
#include "trace/shapes.h"

#include <cmath>
#include <utility>

namespace lixel::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Two triangles for each cell of a grid of corners, `across` corners a row.
void addCells(std::vector<std::uint32_t>& indices, std::uint32_t first, int across, int cellsX, int cellsY)
{
    for (int y = 0; y < cellsY; ++y) {
        for (int x = 0; x < cellsX; ++x) {
            const std::uint32_t a = first + std::uint32_t(y * across + x), b = a + 1, c = a + std::uint32_t(across),
                                d = c + 1;
            indices.insert(indices.end(), {a, b, d, a, d, c});
        }
    }
}

Shape patch(Vec3d corner, Vec3d right, Vec3d up, int cells)
{
    Shape shape;
    for (int y = 0; y <= cells; ++y)
        for (int x = 0; x <= cells; ++x)
            shape.corner.push_back(corner + (double(x) / cells) * right + (double(y) / cells) * up);
    addCells(shape.indices, 0, cells + 1, cells, cells);
    return shape;
}

} // namespace

Shape gridPlane(int cells, double half) { return patch({-half, 0, -half}, {2 * half, 0, 0}, {0, 0, 2 * half}, cells); }

Shape sphere(int slices, int stacks, double radius)
{
    Shape shape;
    for (int j = 0; j <= stacks; ++j) {
        for (int i = 0; i <= slices; ++i) {
            const double polar = kPi * j / stacks, around = 2 * kPi * (i % slices) / slices;
            const double across = j == stacks ? 0 : std::sin(polar);
            shape.corner.push_back(radius *
                                   Vec3d{across * std::cos(around), std::cos(polar), across * std::sin(around)});
        }
    }
    addCells(shape.indices, 0, slices + 1, slices, stacks);
    return shape;
}

Shape box(Vec3d low, Vec3d high, int cells)
{
    const Vec3d size = high - low, x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
    Shape shape = patch(low, x, y, cells);
    for (const Shape& side : {patch(low + z, x, y, cells), patch(low, y, z, cells), patch(low + x, y, z, cells),
                              patch(low, x, z, cells), patch(low + y, x, z, cells)})
        shape = joined(std::move(shape), side);
    return shape;
}

Shape cylinder(int sides, int rings, double radius, double height)
{
    Shape shape;
    for (int j = 0; j <= rings; ++j) {
        for (int i = 0; i <= sides; ++i) {
            const double around = 2 * kPi * (i % sides) / sides;
            shape.corner.push_back({radius * std::cos(around), height * j / rings, radius * std::sin(around)});
        }
    }
    addCells(shape.indices, 0, sides + 1, sides, rings);
    return shape;
}

Shape placed(const Mat4d& worldFromShape, Shape shape)
{
    for (Vec3d& corner : shape.corner) corner = transformPoint(worldFromShape, corner);
    return shape;
}

Shape joined(Shape first, const Shape& second)
{
    const auto offset = std::uint32_t(first.corner.size());
    first.corner.insert(first.corner.end(), second.corner.begin(), second.corner.end());
    for (const std::uint32_t index : second.indices) first.indices.push_back(offset + index);
    return first;
}

LocalTriangles triangles(const Shape& shapeWorld, Vec3d originWorld)
{
    LocalTriangles out;
    out.originWorld = originWorld;
    for (const Vec3d& corner : shapeWorld.corner) out.positionLocal.push_back(toFloat(corner - originWorld));
    out.indices = shapeWorld.indices;
    out.material.assign(out.triangleCount(), 0);
    return out;
}

Mat4d anyRotation(Rng& rng)
{
    const Vec3d z = rng.onSphere(), x = normalized(cross(z, rng.onSphere())), y = cross(z, x);
    return Mat4d::fromRows(direction(x), direction(y), direction(z), {0, 0, 0, 1});
}

Light anyLight(Rng& rng, Vec3d centreWorld, double radius)
{
    Light light;
    const Vec3d towards = rng.onSphere();
    light.kind = rng.chance(0.5) ? LightKind::Directional : LightKind::Point;
    light.directionWorld = -towards;
    light.positionWorld = centreWorld + radius * rng.logUniform(1.5, 1e6) * towards;
    return light;
}

void addSample(ViewSamples& samples, const LocalTriangles& casters, std::uint32_t triangle, Vec3d pointLocal,
               Vec3d towards)
{
    const std::uint32_t* corner = casters.indices.data() + 3 * std::size_t(triangle);
    const Vec3d a = toDouble(casters.positionLocal[corner[0]]), b = toDouble(casters.positionLocal[corner[1]]),
                c = toDouble(casters.positionLocal[corner[2]]);
    const Vec3d n = normalized(cross(b - a, c - a));
    samples.pixel.push_back({0.5f, 0.5f});
    samples.positionLocal.push_back(toFloat(pointLocal));
    samples.normal.push_back(toFloat(dot(n, towards) < 0 ? -n : n));
    samples.triangle.push_back(triangle);
    samples.originWorld = casters.originWorld;
    samples.width = samples.height = 1;
}

ViewSamples anySamplesOn(const LocalTriangles& casters, std::size_t firstTriangle, std::size_t endTriangle, int count,
                         Rng& rng)
{
    ViewSamples samples;
    for (int i = 0; i < count; ++i) {
        const auto triangle = std::uint32_t(rng.integer(int(firstTriangle), int(endTriangle) - 1));
        const std::uint32_t* corner = casters.indices.data() + 3 * std::size_t(triangle);
        const Vec3d a = toDouble(casters.positionLocal[corner[0]]), b = toDouble(casters.positionLocal[corner[1]]),
                    c = toDouble(casters.positionLocal[corner[2]]);
        if (!(length(cross(b - a, c - a)) > 1e-9 * (dot(b - a, b - a) + dot(c - a, c - a))))
            continue; // a pole's sliver
        // Every eighth lies on an edge, every sixteenth at a corner.
        double u = rng.uniform(0, 1), v = rng.uniform(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        if (i % 8 == 0) v = 0;
        if (i % 16 == 0) u = 0;
        addSample(samples, casters, triangle, a + u * (b - a) + v * (c - a), rng.onSphere());
    }
    return samples;
}

} // namespace lixel::test
