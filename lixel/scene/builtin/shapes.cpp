// SPDX-License-Identifier: MIT
#include "lixel/scene/builtin/shapes.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>

namespace lixel::builtin {

namespace {

constexpr double kPi = std::numbers::pi;

Vec3d corner(const Mesh& mesh, std::uint32_t index) { return toDouble(mesh.position[index]); }

// As floats have it; a triangle thinner than their steps is left out.
void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    const Vec3d ab = corner(mesh, b) - corner(mesh, a), ac = corner(mesh, c) - corner(mesh, a);
    if (length(cross(ab, ac)) <= 1e-7 * dot(ab, ab) || length(cross(ab, ac)) <= 1e-7 * dot(ac, ac)) return;
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

std::uint32_t addVertex(Mesh& mesh, Vec3d position, Vec3d normal, Vec2d uv)
{
    mesh.position.push_back(toFloat(position));
    mesh.normal.push_back(toFloat(normal));
    mesh.uv.push_back(toFloat(uv));
    return std::uint32_t(mesh.position.size() - 1);
}

// Four corners, counterclockwise; uv are positions along the first side and at right angles to it.
void addQuad(Mesh& mesh, std::array<Vec3d, 4> p, double metresPerRepeat)
{
    const Vec3d normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
    const Vec3d alongU = normalized(p[1] - p[0]), alongV = cross(normal, alongU);
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2d uv{dot(p[i], alongU), dot(p[i], alongV)};
        const std::uint32_t vertex = addVertex(mesh, p[i], normal, (1 / metresPerRepeat) * uv);
        if (i == 0) first = vertex;
    }
    addTriangle(mesh, first, first + 1, first + 2);
    addTriangle(mesh, first, first + 2, first + 3);
}

// Normals weighted by the triangles' areas, shared by points at the same place.
void smoothNormals(Mesh& mesh)
{
    const auto key = [&](std::uint32_t i) {
        const Vec3f p = mesh.position[i];
        return std::array<float, 3>{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
    };
    std::map<std::array<float, 3>, Vec3d> sums;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::uint32_t* t = &mesh.indices[i];
        const Vec3d areaNormal =
            cross(corner(mesh, t[1]) - corner(mesh, t[0]), corner(mesh, t[2]) - corner(mesh, t[0]));
        for (int k = 0; k < 3; ++k) {
            Vec3d& sum = sums[key(t[k])];
            sum = sum + areaNormal;
        }
    }
    mesh.normal.assign(mesh.position.size(), {0, 1, 0});
    for (std::uint32_t i = 0; i < mesh.position.size(); ++i) {
        const auto sum = sums.find(key(i));
        if (sum != sums.end() && length(sum->second) > 0) mesh.normal[i] = toFloat(normalized(sum->second));
    }
}

std::vector<Vec3d> circle(double radius, int segments)
{
    std::vector<Vec3d> points;
    for (int i = 0; i < segments; ++i) {
        const double a = 2 * kPi * i / segments;
        points.push_back({radius * std::cos(a), 0, -radius * std::sin(a)});
    }
    return points;
}

// Directions of a path at its points, and normals carried along it without turning about it.
struct Frames
{
    std::vector<Vec3d> tangent, normal;
};

Frames carriedFrames(std::span<const Vec3d> path, bool closed)
{
    const std::size_t n = path.size();
    Frames frames;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3d before = i > 0 ? path[i - 1] : closed ? path[n - 1] : path[0];
        const Vec3d after = i + 1 < n ? path[i + 1] : closed ? path[0] : path[n - 1];
        frames.tangent.push_back(normalized(after - before));
    }
    frames.normal.push_back(anyPerpendicular(frames.tangent[0]));
    for (std::size_t i = 1; i < n; ++i) {
        const Vec3d carried = frames.normal[i - 1], t = frames.tangent[i];
        frames.normal.push_back(normalized(carried - dot(carried, t) * t));
    }
    if (!closed) return frames;

    // What the normal has turned by after one round is given back evenly, so that the seam closes.
    const Vec3d t = frames.tangent[0], last = frames.normal[n - 1];
    const Vec3d arrived = normalized(last - dot(last, t) * t);
    const double angle = std::atan2(dot(cross(arrived, frames.normal[0]), t), dot(arrived, frames.normal[0]));
    for (std::size_t i = 0; i < n; ++i) {
        const double a = angle * double(i) / double(n);
        const Vec3d normal = frames.normal[i], binormal = cross(frames.tangent[i], normal);
        frames.normal[i] = std::cos(a) * normal + std::sin(a) * binormal;
    }
    return frames;
}

Vec3d ringPoint(std::span<const Vec3d> path, const Frames& frames, std::size_t i, double radius, double u)
{
    const double a = u >= 1 ? 0 : 2 * kPi * u; // the seam's two sides are the same floats
    const Vec3d normal = frames.normal[i], binormal = cross(frames.tangent[i], normal);
    return path[i] + radius * (std::cos(a) * normal + std::sin(a) * binormal);
}

// A flat disc of the ring at one end of a tube; `outwards` is its normal.
void addCap(Mesh& mesh, const std::vector<Vec3d>& ring, Vec3d centre, Vec3d outwards)
{
    const std::uint32_t middle = addVertex(mesh, centre, outwards, {0, 0});
    const std::uint32_t first = middle + 1, n = std::uint32_t(ring.size());
    for (const Vec3d& p : ring) addVertex(mesh, p, outwards, {0, 0});
    const bool sameSense = dot(cross(ring[0] - centre, ring[1] - centre), outwards) > 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = first + i, b = first + (i + 1) % n;
        addTriangle(mesh, middle, sameSense ? a : b, sameSense ? b : a);
    }
}

} // namespace

Mesh surface(const std::function<Vec3d(double u, double v)>& f, int columns, int rows, Vec2d uvScale)
{
    Mesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double u = double(i) / columns, v = double(j) / rows;
            addVertex(mesh, f(u, v), {0, 1, 0}, {u * uvScale.x, v * uvScale.y});
        }
    const std::uint32_t stride = std::uint32_t(columns + 1);
    for (std::uint32_t j = 0; j < std::uint32_t(rows); ++j)
        for (std::uint32_t i = 0; i < std::uint32_t(columns); ++i) {
            const std::uint32_t a = j * stride + i;
            addTriangle(mesh, a, a + 1, a + stride + 1);
            addTriangle(mesh, a, a + stride + 1, a + stride);
        }
    smoothNormals(mesh);
    return mesh;
}

Mesh box(Vec3d a, Vec3d b, double metresPerRepeat)
{
    Mesh mesh;
    const auto quad = [&](Vec3d p0, Vec3d p1, Vec3d p2, Vec3d p3) { addQuad(mesh, {p0, p1, p2, p3}, metresPerRepeat); };
    quad({a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z}); // top
    quad({a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}); // bottom
    quad({a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}); // +z
    quad({b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}); // -z
    quad({b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}); // +x
    quad({a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}); // -x
    return mesh;
}

Mesh boxAround(Vec3d centre, Vec3d size, double metresPerRepeat)
{
    return box(centre - 0.5 * size, centre + 0.5 * size, metresPerRepeat);
}

Mesh lathe(std::span<const Vec2d> profile, int segments, Vec2d uvScale)
{
    const std::vector<Vec3d> round = circle(1, segments);
    Mesh mesh;
    for (std::size_t first = 0; first + 1 < profile.size();) {
        std::size_t last = first + 1;
        while (last + 1 < profile.size() && !(profile[last + 1] == profile[last])) ++last;
        const int rows = int(last - first);
        const auto point = [&](double u, double v) {
            const Vec2d p = profile[first + std::size_t(std::lround(v * rows))];
            const Vec3d r = round[std::size_t(std::lround(u * segments)) % round.size()];
            return Vec3d{p.x * r.x, p.y, p.x * r.z};
        };
        append(mesh, surface(point, segments, rows, uvScale));
        first = last + 1;
    }
    return mesh;
}

std::vector<Vec2d> smoothProfile(std::span<const Vec2d> points, int steps)
{
    // Catmull-Rom spans; at ends and creases the missing neighbour is the point itself.
    std::vector<Vec2d> profile;
    const auto isCrease = [&](std::size_t a, std::size_t b) { return points[a] == points[b]; };
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2d p1 = points[i], p2 = points[i + 1];
        profile.push_back(p1);
        if (isCrease(i, i + 1)) continue;
        const Vec2d p0 = i > 0 ? points[i - 1] : p1, p3 = i + 2 < points.size() ? points[i + 2] : p2;
        for (int k = 1; k < steps; ++k) {
            const double t = double(k) / steps;
            const Vec2d p = 0.5 * (2 * p1 + t * (p2 - p0) + t * t * (2 * p0 - 5 * p1 + 4 * p2 - p3) +
                                   t * t * t * (3 * p1 - p0 - 3 * p2 + p3));
            profile.push_back({std::max(p.x, 1e-4), p.y});
        }
    }
    profile.push_back(points.back());
    return profile;
}

Mesh sphere(double radius, int segments)
{
    std::vector<Vec2d> profile;
    const int rows = std::max(2, segments / 2);
    for (int i = 0; i <= rows; ++i) {
        const double a = kPi * i / rows;
        profile.push_back({i == 0 || i == rows ? 0 : radius * std::sin(a), -radius * std::cos(a)});
    }
    return lathe(profile, segments);
}

Mesh cylinder(double radius, double height, int segments)
{
    const Vec2d profile[] = {{0, 0}, {radius, 0}, {radius, 0}, {radius, height}, {radius, height}, {0, height}};
    return lathe(profile, segments);
}

Mesh cone(double radius, double height, int segments)
{
    const Vec2d profile[] = {{0, 0}, {radius, 0}, {radius, 0}, {0.5 * radius, 0.5 * height}, {0, height}};
    return lathe(profile, segments);
}

Mesh torus(double ringRadius, double tubeRadius, int segments, int sides)
{
    return loopTube(circle(ringRadius, segments), tubeRadius, sides);
}

Mesh torusKnot(int p, int q, double size, double tubeRadius, int segments, int sides)
{
    std::vector<Vec3d> loop;
    for (int i = 0; i < segments; ++i) {
        const double a = 2 * kPi * i / segments, r = size * (1 + 0.42 * std::cos(q * a));
        loop.push_back({r * std::cos(p * a), size * 0.42 * std::sin(q * a), -r * std::sin(p * a)});
    }
    return loopTube(loop, tubeRadius, sides);
}

Mesh tube(std::span<const Vec3d> path, double radiusStart, double radiusEnd, int sides)
{
    const Frames frames = carriedFrames(path, false);
    const int rows = int(path.size()) - 1;
    const auto point = [&](double u, double v) {
        return ringPoint(path, frames, std::size_t(std::lround(v * rows)), radiusStart + v * (radiusEnd - radiusStart),
                         u);
    };
    Mesh mesh = surface(point, sides, rows);
    std::vector<Vec3d> startRing, endRing;
    for (int i = 0; i < sides; ++i) {
        startRing.push_back(point(double(i) / sides, 0));
        endRing.push_back(point(double(i) / sides, 1));
    }
    if (radiusStart > 0) addCap(mesh, startRing, path.front(), -frames.tangent.front());
    if (radiusEnd > 0) addCap(mesh, endRing, path.back(), frames.tangent.back());
    return mesh;
}

Mesh loopTube(std::span<const Vec3d> loop, double radius, int sides)
{
    const Frames frames = carriedFrames(loop, true);
    const int rows = int(loop.size());
    const auto point = [&](double u, double v) {
        return ringPoint(loop, frames, std::size_t(std::lround(v * rows)) % loop.size(), radius, u);
    };
    return surface(point, sides, rows);
}

Mesh rod(Vec3d from, Vec3d to, double radius, int sides)
{
    const Vec3d path[] = {from, to};
    return tube(path, radius, radius, sides);
}

Mesh band(std::span<const Vec2d> lower, std::span<const Vec2d> upper, double depth, double metresPerRepeat)
{
    LX_ASSERT(lower.size() == upper.size() && lower.size() >= 2);
    const std::size_t n = lower.size();
    const double front = 0.5 * depth, back = -0.5 * depth;
    const auto lift = [](Vec2d p, double z) { return Vec3d{p.x, p.y, z}; };

    // Front and back are strips of flat quads; under- and upper side are smooth along the curve.
    Mesh mesh;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        addQuad(mesh,
                {lift(lower[i], front), lift(lower[i + 1], front), lift(upper[i + 1], front), lift(upper[i], front)},
                metresPerRepeat);
        addQuad(mesh, {lift(lower[i + 1], back), lift(lower[i], back), lift(upper[i], back), lift(upper[i + 1], back)},
                metresPerRepeat);
    }
    const int columns = int(n) - 1;
    const auto index = [&](double u) { return std::size_t(std::lround(u * columns)); };
    double lengthOfCurve = 0;
    for (std::size_t i = 0; i + 1 < n; ++i) lengthOfCurve += length(lower[i + 1] - lower[i]);
    const Vec2d uvScale{lengthOfCurve / metresPerRepeat, depth / metresPerRepeat};
    append(mesh,
           surface([&](double u, double v) { return lift(lower[index(u)], back + v * depth); }, columns, 1, uvScale));
    append(mesh,
           surface([&](double u, double v) { return lift(upper[index(u)], front - v * depth); }, columns, 1, uvScale));
    addQuad(mesh, {lift(lower[0], back), lift(lower[0], front), lift(upper[0], front), lift(upper[0], back)},
            metresPerRepeat);
    addQuad(mesh,
            {lift(lower[n - 1], front), lift(lower[n - 1], back), lift(upper[n - 1], back), lift(upper[n - 1], front)},
            metresPerRepeat);
    return mesh;
}

Mesh wallWithHole(Rectangle2 wall, Rectangle2 hole, double depth, double metresPerRepeat)
{
    const auto corners = [](Rectangle2 r) {
        return std::array<Vec2d, 4>{r.min, Vec2d{r.max.x, r.min.y}, r.max, Vec2d{r.min.x, r.max.y}};
    };
    const std::array<Vec2d, 4> outer = corners(wall), inner = corners(hole);
    const double front = 0.5 * depth, back = -0.5 * depth;
    Mesh mesh;
    // Both faces are four trapezoids between the rectangles; their uv lie in (x, y) so that a texture runs on.
    const auto face = [&](std::size_t i, std::size_t next, double z) {
        const Vec2d corner[] = {outer[i], outer[next], inner[next], inner[i]};
        std::uint32_t first = std::uint32_t(mesh.position.size());
        for (const Vec2d& p : corner)
            addVertex(mesh, {p.x, p.y, z}, {0, 0, z > 0 ? 1.0 : -1.0}, (1 / metresPerRepeat) * p);
        addTriangle(mesh, first, first + (z > 0 ? 1 : 2), first + (z > 0 ? 2 : 1));
        addTriangle(mesh, first, first + (z > 0 ? 2 : 3), first + (z > 0 ? 3 : 2));
    };
    const auto side = [&](Vec2d a, Vec2d b) { // outside on the right of a to b
        addQuad(mesh, {Vec3d{a.x, a.y, back}, {b.x, b.y, back}, {b.x, b.y, front}, {a.x, a.y, front}}, metresPerRepeat);
    };
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        face(i, next, front);
        face(i, next, back);
        side(outer[i], outer[next]);
        side(inner[next], inner[i]);
    }
    return mesh;
}

Mesh prism(std::span<const Vec2d> polygon, double depth)
{
    Mesh mesh;
    std::vector<Vec3d> front, back;
    for (const Vec2d& p : polygon) {
        front.push_back({p.x, p.y, 0.5 * depth});
        back.push_back({p.x, p.y, -0.5 * depth});
    }
    addCap(mesh, front, {0, 0, 0.5 * depth}, {0, 0, 1});
    addCap(mesh, back, {0, 0, -0.5 * depth}, {0, 0, -1});
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t next = (i + 1) % polygon.size();
        addQuad(mesh, {back[i], back[next], front[next], front[i]}, 1);
    }
    return mesh;
}

Mesh softBox(Vec3d size, double exponent, int segments)
{
    const auto pushed = [&](double unit) { return std::copysign(std::pow(std::abs(unit), 2 / exponent), unit); };
    Mesh mesh = sphere(1, segments);
    for (Vec3f& p : mesh.position)
        p = toFloat(Vec3d{0.5 * size.x * pushed(p.x), 0.5 * size.y * (1 + pushed(p.y)), 0.5 * size.z * pushed(p.z)});
    std::vector<std::uint32_t> indices;
    indices.swap(mesh.indices);
    for (std::size_t i = 0; i < indices.size(); i += 3) addTriangle(mesh, indices[i], indices[i + 1], indices[i + 2]);
    smoothNormals(mesh);
    return mesh;
}

Mesh bunny()
{
#include "bunny_mesh.inc"
    Mesh mesh;
    for (const float* p : kBunnyPositions) {
        mesh.position.push_back({p[0], p[1], p[2]});
        mesh.uv.push_back({p[0], p[1]});
    }
    mesh.indices.assign(std::begin(kBunnyIndices), std::end(kBunnyIndices));
    smoothNormals(mesh);
    return mesh;
}

void append(Mesh& whole, const Mesh& part, const Mat4d& wholeFromPart)
{
    const std::optional<Mat4d> inverted = inverse(wholeFromPart);
    LX_ASSERT(inverted);
    const Mat4d normalFromNormal = transpose(*inverted);
    const std::uint32_t first = std::uint32_t(whole.position.size());
    for (std::size_t i = 0; i < part.position.size(); ++i) {
        whole.position.push_back(toFloat(transformPoint(wholeFromPart, toDouble(part.position[i]))));
        whole.normal.push_back(toFloat(normalized(transformDirection(normalFromNormal, toDouble(part.normal[i])))));
    }
    whole.uv.insert(whole.uv.end(), part.uv.begin(), part.uv.end());
    for (std::uint32_t index : part.indices) whole.indices.push_back(first + index);
}

Mat4d at(Vec3d position) { return translation(position); }

Mat4d turnedY(double degrees) { return turned({0, 1, 0}, degrees); }

Mat4d turned(Vec3d axis, double degrees)
{
    const Vec3d a = normalized(axis);
    const double angle = degrees * kPi / 180, c = std::cos(angle), s = std::sin(angle), t = 1 - c;
    return Mat4d::fromRows({c + a.x * a.x * t, a.x * a.y * t - a.z * s, a.x * a.z * t + a.y * s, 0},
                           {a.y * a.x * t + a.z * s, c + a.y * a.y * t, a.y * a.z * t - a.x * s, 0},
                           {a.z * a.x * t - a.y * s, a.z * a.y * t + a.x * s, c + a.z * a.z * t, 0}, {0, 0, 0, 1});
}

} // namespace lixel::builtin
