// SPDX-License-Identifier: MIT
#include "lixel/plan/fit/lixel_energy.h"

#include "lixel/plan/footprint.h"
#include "plan/edge_scenes.h"
#include "support/dual.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace lixel {
namespace {

using namespace test;

// d pixel / d lixel of one sample: [pixel x or y][u of row x or y].
using Inverse = std::array<std::array<double, 2>, 2>;

Inverse inverseOf(const std::array<std::array<double, 2>, 2>& m)
{
    const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return {{{m[1][1] / determinant, -m[0][1] / determinant}, {-m[1][0] / determinant, m[0][0] / determinant}}};
}

// As EdgeRays have it.
Inverse inverseBy(const EdgeRays& rays, std::size_t i, const PlaneWarp& map)
{
    const DualBasis dual = dualBasis(map);
    const auto at = [i](const EdgeRays::Vectors& v) { return Vec3d{v[0][i], v[1][i], v[2][i]}; };
    const double w = dot(map.w, at(rays.ray));
    const Vec3d k1 = at(rays.first), k2 = at(rays.second);
    return {{{w * dot(k1, dual.b1), w * dot(k1, dual.b2)}, {w * dot(k2, dual.b1), w * dot(k2, dual.b2)}}};
}

double farthest(const Inverse& a, const Inverse& b)
{
    double apart = 0, size = 0;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            apart = std::max(apart, std::abs(a[std::size_t(i)][std::size_t(j)] - b[std::size_t(i)][std::size_t(j)]));
            size = std::max(size, std::abs(b[std::size_t(i)][std::size_t(j)]));
        }
    return apart / size;
}

// The view in pixels, from a frame of the light that has its point at the origin (light space), or from Local.
Mat4d pixelsFrom(const EdgeScene& s)
{
    Mat4d pixels = clipFromLocal(s.view, s.originWorld);
    pixels.setRow(0, 0.5 * s.view.width * (pixels.row(0) + pixels.row(3)));
    pixels.setRow(1, 0.5 * s.view.height * (pixels.row(1) + pixels.row(3)));
    return pixels;
}

// Chong & Gortler 2007, section 2.1 and appendix A, in its own letters.
class Appendix
{
public:
    // P's rows 1, 2 and 4 without their zeros.
    Appendix(const EdgeScene& s, const NeedSample& sample, const PlaneWarp& map) : p_{map.x, map.y}, p4_(map.w)
    {
        const LightFrame& frame = s.frame;
        Mat4d lightFromLocal = frame.framedFromLocal;
        lightFromLocal.setRow(3, {0, 0, 0, 1});
        const Mat4d Q = pixelsFrom(s) * inverse(lightFromLocal).value(), back = inverse(Q).value();
        X_ = transformPoint(lightFromLocal, sample.pointLocal);
        wq_ = (Q * point(X_)).w;
        for (std::size_t j = 0; j < 4; ++j) q_[j] = {back.m[0][j], back.m[1][j], back.m[2][j]};
        // The surface on the screen, a plane again: x3 as a function of x1 and x2.
        const Vec3d n = transformDirection(lightFromLocal, sample.normal);
        const std::array<double, 4> plane{n.x, n.y, n.z, -dot(n, X_)};
        std::array<double, 4> onScreen{};
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k) onScreen[j] += plane[k] * back.m[k][j];
        dx3_ = {-onScreen[0] / onScreen[2], -onScreen[1] / onScreen[2]};
    }

    // Equation 8, i = 1, 2, j = 1, 2, 3.
    double partial(std::size_t i, std::size_t j) const
    {
        const double p4X = dot(p4_, X_);
        return wq_ / p4X * (dot(p_[i], q_[j]) - dot(p_[i], X_) / p4X * dot(p4_, q_[j]));
    }

    // The appendix' last equation.
    Vec3d gradientOfPartial(std::size_t i, std::size_t j) const
    {
        const double p4X = dot(p4_, X_), piX = dot(p_[i], X_);
        return wq_ / (p4X * p4X) * ((2 * piX * dot(p4_, q_[j]) / p4X - dot(p_[i], q_[j])) * X_ - piX * q_[j]);
    }

    // Equation 7.
    double total(std::size_t i, std::size_t j) const { return partial(i, j) + partial(i, 2) * dx3_[j]; }
    Vec3d gradientOfTotal(std::size_t i, std::size_t j) const
    {
        return gradientOfPartial(i, j) + dx3_[j] * gradientOfPartial(i, 2);
    }

    Inverse inverseJacobian() const { return inverseOf({{{total(0, 0), total(0, 1)}, {total(1, 0), total(1, 1)}}}); }

    // A sample's addend to equation 9.
    double badness() const
    {
        double squares = 0;
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j < 2; ++j) squares += total(i, j) * total(i, j);
        const double detJ = total(0, 0) * total(1, 1) - total(0, 1) * total(1, 0);
        return squares / (detJ * detJ);
    }
    // By the product rule.
    Vec3d gradientOfBadness() const
    {
        const double detJ = total(0, 0) * total(1, 1) - total(0, 1) * total(1, 0);
        Vec3d ofSquares;
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j < 2; ++j) ofSquares = ofSquares + 2 * total(i, j) * gradientOfTotal(i, j);
        const Vec3d ofDet = total(1, 1) * gradientOfTotal(0, 0) + total(0, 0) * gradientOfTotal(1, 1) -
                            total(1, 0) * gradientOfTotal(0, 1) - total(0, 1) * gradientOfTotal(1, 0);
        return ofSquares / (detJ * detJ) - (2 * badness() / detJ) * ofDet;
    }

private:
    std::array<Vec3d, 2> p_;
    Vec3d p4_, X_;
    double wq_ = 0;
    std::array<Vec3d, 4> q_;
    std::array<double, 2> dx3_{};
};

// Where the sample's surface is seen in a pixel, and where that is on the light plane: a step on the picture.
std::optional<Vec3d> rayAtPixel(const EdgeScene& s, const NeedSample& sample, Vec2d step)
{
    const Mat4d pixels = pixelsFrom(s), back = inverse(pixels).value();
    const Vec3d at = project(pixels, sample.pointLocal);
    const Vec4d front = back * Vec4d{at.x + step.x, at.y + step.y, -1, 1},
                far = back * Vec4d{at.x + step.x, at.y + step.y, 0.5, 1};
    const Vec3d a = xyz(front) / front.w, b = xyz(far) / far.w;
    const double along = dot(sample.normal, b - a);
    const double t = dot(sample.normal, sample.pointLocal - a) / along;
    const Vec4d r = s.frame.framedFromLocal * point(a + t * (b - a));
    return Vec3d{r.x, r.y, r.w};
}

Vec2d mapped(const PlaneWarp& map, Vec3d r) { return {dot(map.x, r) / dot(map.w, r), dot(map.y, r) / dot(map.w, r)}; }

TEST(EdgeRays, HaveTheDerivativesOfTheAppendixForLightsAtAPoint)
{
    int tried = 0;
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        if (!s.frame.isPerspective) return;
        ASSERT_EQ(s.rays.size(), s.samples.size());
        const PlaneWarp map = anyMap(rng, s.rays);
        for (std::size_t i = 0; i < s.samples.size(); ++i)
            EXPECT_LT(farthest(inverseBy(s.rays, i, map), Appendix(s, s.samples[i], map).inverseJacobian()), 1e-8);
        ++tried;
    });
    EXPECT_GT(tried, 0);
}

// Parallel light: lixels are a planar map of two linear functions of place, along the surface.
TEST(EdgeRays, HaveTheDerivativesOfPlanarMapsForParallelLight)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        if (s.frame.isPerspective) return;
        ASSERT_EQ(s.rays.size(), s.samples.size());
        const PlaneWarp map = anyMap(rng, s.rays);
        const Mat4d pixels = pixelsFrom(s);
        const Vec4d across = s.frame.framedFromLocal.row(0), up = s.frame.framedFromLocal.row(1);
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            const Vec3d p = s.samples[i].pointLocal, n = s.samples[i].normal;
            const Vec3d tangent[] = {anyPerpendicular(n), cross(n, anyPerpendicular(n))};
            const Vec4d clip = pixels * point(p);
            const double S = dot(across, point(p)), T = dot(up, point(p));
            const double x = dot(map.x, {S, T, 1}), y = dot(map.y, {S, T, 1}), w = dot(map.w, {S, T, 1});
            // Along each tangent: the quotient rule for pixels and for lixels.
            std::array<std::array<double, 2>, 2> pixel{}, lixel{};
            for (std::size_t t = 0; t < 2; ++t) {
                const Vec4d d = pixels * direction(tangent[t]);
                pixel[0][t] = (d.x * clip.w - clip.x * d.w) / (clip.w * clip.w);
                pixel[1][t] = (d.y * clip.w - clip.y * d.w) / (clip.w * clip.w);
                const double dS = dot(xyz(across), tangent[t]), dT = dot(xyz(up), tangent[t]);
                const double dw = map.w.x * dS + map.w.y * dT;
                lixel[0][t] = ((map.x.x * dS + map.x.y * dT) * w - x * dw) / (w * w);
                lixel[1][t] = ((map.y.x * dS + map.y.y * dT) * w - y * dw) / (w * w);
            }
            const Inverse back = inverseOf(lixel);
            Inverse expected{};
            for (std::size_t r = 0; r < 2; ++r)
                for (std::size_t c = 0; c < 2; ++c)
                    expected[r][c] = pixel[r][0] * back[0][c] + pixel[r][1] * back[1][c];
            EXPECT_LT(farthest(inverseBy(s.rays, i, map), expected), 1e-8);
        }
    });
}

TEST(EdgeRays, HaveTheDerivativesThatSmallStepsInThePictureShow)
{
    forEachCase(kCases / 4, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng, 10);
        const PlaneWarp map = anyMap(rng, s.rays);
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            constexpr double h = 1e-3; // pixels
            std::array<std::array<double, 2>, 2> jacobian{};
            for (std::size_t j = 0; j < 2; ++j) {
                const Vec2d step = j == 0 ? Vec2d{h, 0} : Vec2d{0, h};
                const Vec2d change = (0.5 / h) * (mapped(map, *rayAtPixel(s, s.samples[i], step)) -
                                                  mapped(map, *rayAtPixel(s, s.samples[i], -1.0 * step)));
                jacobian[0][j] = change.x, jacobian[1][j] = change.y;
            }
            EXPECT_LT(farthest(inverseBy(s.rays, i, map), inverseOf(jacobian)), 1e-4);
        }
    });
}

// The light clip matrix whose lixels are those of a map of one: of its square, whose side is 2.
Mat4d clipOf(const EdgeScene& s, const PlaneWarp& map)
{
    const Mat4d& framed = s.frame.framedFromLocal;
    const auto row = [&](Vec3d r) { return r.x * framed.row(0) + r.y * framed.row(1) + r.z * framed.row(3); };
    return Mat4d::fromRows(2.0 * row(map.x), 2.0 * row(map.y), framed.row(2), row(map.w));
}

TEST(EdgeRays, AreTheFootprintsInverse)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        PlaneWarp map = anyMap(rng, s.rays);
        double most = 0; // of the samples' places in the map, which is to hold them all
        for (std::size_t i = 0; i < s.rays.size(); ++i) {
            const Vec2d u = mapped(map, {s.rays.ray[0][i], s.rays.ray[1][i], s.rays.ray[2][i]});
            most = std::max({most, std::abs(u.x), std::abs(u.y)});
        }
        map.x = (0.4 / most) * map.x, map.y = (0.4 / most) * map.y;
        const LightImage image(clipOf(s, map), {0, 0, 1, 1, 0});
        std::vector<double> bad;
        badnesses(s.rays, map, bad);
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            const auto f = footprint(s.view, s.originWorld, image, s.samples[i].pointLocal, s.samples[i].normal);
            ASSERT_TRUE(f);
            const auto& m = f->lixelFromPixel;
            const Inverse expected = inverseOf({{{m[0][0], m[0][1]}, {m[1][0], m[1][1]}}});
            EXPECT_LT(farthest(inverseBy(s.rays, i, map), expected), 1e-8);
            EXPECT_NEAR(bad[i],
                        std::pow(expected[0][0], 2) + std::pow(expected[0][1], 2) + std::pow(expected[1][0], 2) +
                            std::pow(expected[1][1], 2),
                        1e-7 * bad[i]);
        }
    });
}

TEST(EdgeRays, LeaveOutSurfacesThatAreEdgeOn)
{
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng, 10);
        const std::size_t count = s.samples.size();
        const Vec3d p = s.samples[0].pointLocal;
        for (const Vec3d along : {towardsEye(s.view, s.originWorld, p), towardsLight(s.light, s.originWorld, p)})
            s.samples.push_back({p, normalized(cross(along, rng.onSphere()))});
        s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
        EXPECT_EQ(s.rays.size(), count);
    });
}

// The energies from their definitions, with the paper's derivatives for lights at a point.
TEST(LixelEnergy, IsTheMeanOfWhatTheMetricSaysOfEachSample)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        double weights = 0;
        std::array<double, 4> sums{};
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            const NeedSample& sample = s.samples[i];
            const Inverse m =
                s.frame.isPerspective ? Appendix(s, sample, map).inverseJacobian() : inverseBy(s.rays, i, map);
            const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
            double squares = 0;
            for (const auto& row : m) squares += row[0] * row[0] + row[1] * row[1];
            weights += sample.weight;
            sums[0] += sample.weight * squares;
            // Of the singular values, the roots of s^4 - |m|^2 s^2 + det^2, the larger one.
            sums[1] += sample.weight *
                       std::sqrt(0.5 * (squares +
                                        std::sqrt(std::max(0.0, squares * squares - 4 * determinant * determinant))));
            sums[2] += sample.weight * std::abs(determinant);
            // Across the edge a step of u j is as wide as it is along the edge's normal.
            const auto width = [&](Vec2d n) {
                return std::abs(n.x * m[0][0] + n.y * m[1][0]) + std::abs(n.x * m[0][1] + n.y * m[1][1]);
            };
            if (dot(sample.across, sample.across) > 0) {
                sums[3] += sample.weight * width(sample.across);
                continue;
            }
            // Edges on the surface at 0, 45, 90 and 135 degrees to a tangent, each as wide as the surface is foreshortened.
            const Mat4d pixels = pixelsFrom(s);
            const Vec3d t1 = anyPerpendicular(sample.normal), t2 = cross(sample.normal, t1);
            const Vec4d clip = pixels * point(sample.pointLocal);
            const auto onPicture = [&](Vec3d t) {
                const Vec4d d = pixels * direction(t);
                return Vec2d{(d.x - d.w * clip.x / clip.w) / clip.w, (d.y - d.w * clip.y / clip.w) / clip.w};
            };
            const Vec2d p1 = onPicture(t1), p2 = onPicture(t2);
            const double size = std::sqrt(0.5 * (dot(p1, p1) + dot(p2, p2)));
            for (int k = 0; k < 4; ++k) {
                const double angle = k * 0.7853981633974483;
                const Vec2d alongEdge = -std::sin(angle) * p1 + std::cos(angle) * p2; // on the picture
                sums[3] += 0.25 * sample.weight * width((1 / size) * Vec2d{alongEdge.y, -alongEdge.x});
            }
        }
        for (std::size_t metric = 0; metric < 4; ++metric) {
            const double expected = sums[metric] / weights;
            EXPECT_NEAR(lixelEnergy(kAllMetrics[metric], s.rays, map), expected, 1e-7 * expected)
                << nameOf(kAllMetrics[metric]);
        }
    });
}

TEST(LixelEnergy, IsInfiniteWhereASampleIsNotBeforeTheMap)
{
    forEachCase(kCases / 10, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        PlaneWarp map = anyMap(rng, s.rays);
        const std::size_t i = std::size_t(rng.integer(0, int(s.rays.size()) - 1));
        const Vec3d r{s.rays.ray[0][i], s.rays.ray[1][i], s.rays.ray[2][i]};
        map.w = map.w - (rng.uniform(1, 2) * dot(map.w, r) / dot(r, r)) * r;
        for (const LixelMetric metric : kAllMetrics) {
            EXPECT_EQ(lixelEnergy(metric, s.rays, map), INFINITY);
            EXPECT_EQ(lixelEnergyChange(metric, s.rays, map).energy, INFINITY);
        }
    });
}

// The appendix' gradient formula, sample by sample.
TEST(LixelEnergy, HasTheAppendixGradientForLightsAtAPoint)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        if (!s.frame.isPerspective) return;
        const PlaneWarp map = anyMap(rng, s.rays);
        double weights = 0;
        Vec3d expected;
        for (const NeedSample& sample : s.samples) {
            weights += sample.weight;
            expected = expected + sample.weight * Appendix(s, sample, map).gradientOfBadness();
        }
        expected = expected / weights;
        const EnergyChange change = lixelEnergyChange(LixelMetric::L2, s.rays, map);
        EXPECT_LT(length(change.withW - expected), 1e-7 * length(expected));
    });
}

// ---- derivatives of energies

// Energies once more, from rays and how they move a pixel, in numbers of any kind: Jacobians forwards, then inverted.
class EnergyTwin
{
public:
    explicit EnergyTwin(const EdgeScene& s)
    {
        const Mat4d back = inverse(pixelsFrom(s)).value();
        for (const NeedSample& sample : s.samples) {
            const Vec3d at = project(pixelsFrom(s), sample.pointLocal);
            const std::array<double, 4> plane{sample.normal.x, sample.normal.y, sample.normal.z,
                                              -dot(sample.normal, sample.pointLocal)};
            std::array<double, 4> onScreen{};
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t k = 0; k < 4; ++k) onScreen[j] += plane[k] * back.m[k][j];
            Ray ray{sample, rayOf(s, point(sample.pointLocal)), {}};
            const double perW = 1 / (back * Vec4d{at.x, at.y, at.z, 1}).w;
            for (std::size_t j = 0; j < 2; ++j) {
                const Vec4d d = back * Vec4d{j == 0 ? 1.0 : 0, j == 1 ? 1.0 : 0, -onScreen[j] / onScreen[2], 0};
                const Vec3d moved = perW * (xyz(d) - d.w * sample.pointLocal);
                ray.aPixel[j] = rayOf(s, direction(moved));
            }
            rays_.push_back(ray);
        }
    }

    template <typename Number, typename Vector>
    Number energy(LixelMetric metric, const PlaneWarp& map, const Vector& w) const
    {
        using std::abs, std::sqrt;
        Number sum = 0;
        double weights = 0;
        for (const Ray& ray : rays_) {
            weights += ray.sample.weight;
            Number m[2][2];
            const Number wr = dot(w, ray.r);
            for (std::size_t i = 0; i < 2; ++i)
                for (std::size_t j = 0; j < 2; ++j) {
                    const Vec3d row = i == 0 ? map.x : map.y;
                    m[i][j] = (wr * dot(row, ray.aPixel[j]) - dot(row, ray.r) * dot(w, ray.aPixel[j])) / (wr * wr);
                }
            const Number det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
            const Number i11 = m[1][1] / det, i12 = 0.0 - m[0][1] / det, i21 = 0.0 - m[1][0] / det, i22 = m[0][0] / det;
            const Number squares = i11 * i11 + i12 * i12 + i21 * i21 + i22 * i22, area = i11 * i22 - i12 * i21;
            Number value = squares;
            if (metric == LixelMetric::Area) value = abs(area);
            if (metric == LixelMetric::Lloyd)
                value = sqrt(0.5 * (squares + sqrt(squares * squares - 4.0 * area * area)));
            if (metric == LixelMetric::Width) {
                const Vec2d n = ray.sample.across;
                value = abs(n.x * i11 + n.y * i21) + abs(n.x * i12 + n.y * i22);
            }
            sum = sum + ray.sample.weight * value;
        }
        return sum / weights;
    }

private:
    struct Ray
    {
        NeedSample sample;
        Vec3d r;
        std::array<Vec3d, 2> aPixel{};
    };
    static Vec3d rayOf(const EdgeScene& s, Vec4d p)
    {
        const Vec4d r = s.frame.framedFromLocal * p;
        return {r.x, r.y, r.w};
    }
    std::vector<Ray> rays_;
};

// Of all samples those where no metric has an edge near: lixels far from round, and no side along the shadow's edge.
void keepSmooth(EdgeScene& s, const PlaneWarp& map)
{
    std::vector<NeedSample> smooth;
    for (std::size_t i = 0; i < s.samples.size(); ++i) {
        const Inverse m = inverseBy(s.rays, i, map);
        const Vec2d n = s.samples[i].across;
        if (!(dot(n, n) > 0)) continue;
        const double a = std::hypot(m[0][0] + m[1][1], m[1][0] - m[0][1]),
                     b = std::hypot(m[0][0] - m[1][1], m[1][0] + m[0][1]);
        const double c = std::abs(n.x * m[0][0] + n.y * m[1][0]), d = std::abs(n.x * m[0][1] + n.y * m[1][1]);
        const double sizeOfFirst = std::hypot(m[0][0], m[1][0]), sizeOfSecond = std::hypot(m[0][1], m[1][1]);
        if (std::min(a, b) < 0.05 * std::max(a, b) || c < 0.05 * sizeOfFirst || d < 0.05 * sizeOfSecond) continue;
        smooth.push_back(s.samples[i]);
    }
    s.samples = smooth;
    s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
}

TEST(LixelEnergyChange, IsTheAutomaticDerivative)
{
    double worst = 0;
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        keepSmooth(s, map);
        if (s.samples.empty()) return;
        const EnergyTwin twin(s);
        for (const LixelMetric metric : kAllMetrics) {
            const Dual expected = twin.energy<Dual>(metric, map, variables(map.w));
            const EnergyChange change = lixelEnergyChange(metric, s.rays, map);
            EXPECT_NEAR(change.energy, expected.value, 1e-9 * expected.value) << nameOf(metric);
            EXPECT_NEAR(change.energy, lixelEnergy(metric, s.rays, map), 1e-12 * expected.value) << nameOf(metric);
            const double apart = length(change.withW - expected.by) / length(expected.by);
            EXPECT_LT(apart, 1e-9) << nameOf(metric);
            worst = std::max(worst, apart);
        }
    });
    RecordProperty("worst", std::to_string(worst));
    std::printf("farthest from automatic differentiation: %.2e of the gradient\n", worst);
}

// Central differences of the energies themselves. Of all steps that one whose halves agree best.
TEST(LixelEnergyChange, IsWhatSmallTurnsOfTheAxisShow)
{
    double worst = 0;
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        keepSmooth(s, map);
        if (s.samples.empty()) return;
        for (const LixelMetric metric : kAllMetrics) {
            const auto slopeBy = [&](double h) {
                const auto along = [&](Vec3d step) {
                    PlaneWarp before = map, after = map;
                    before.w = map.w - step, after.w = map.w + step;
                    return (lixelEnergy(metric, s.rays, after) - lixelEnergy(metric, s.rays, before)) / (2 * h);
                };
                return Vec3d{along({h, 0, 0}), along({0, h, 0}), along({0, 0, h})};
            };
            Vec3d best;
            double least = INFINITY;
            for (double h = 1e-3 * length(map.w); h > 1e-7 * length(map.w); h *= 0.5) {
                // Richardson's two.
                const Vec3d coarse = slopeBy(h), fine = slopeBy(0.5 * h);
                const double apart = length(fine - coarse);
                if (apart < least) least = apart, best = (4.0 * fine - coarse) / 3.0;
            }
            const Vec3d slope = lixelEnergyChange(metric, s.rays, map).withW;
            const double apart = length(slope - best) / length(slope);
            EXPECT_LT(apart, 1e-6) << nameOf(metric);
            worst = std::max(worst, apart);
        }
    });
    std::printf("farthest from central differences: %.2e of the gradient\n", worst);
}

// ---- closed forms

double squaresOf(const SquaresForm& form, const PlaneWarp& map)
{
    const DualBasis dual = dualBasis(map);
    const auto q = form.at(map.w);
    const auto of = [&q](Vec3d b) {
        return q[0] * b.x * b.x + q[3] * b.y * b.y + q[5] * b.z * b.z +
               2 * (q[1] * b.x * b.y + q[2] * b.x * b.z + q[4] * b.y * b.z);
    };
    return of(dual.b1) + of(dual.b2);
}

TEST(LixelEnergy, OfTheSquaresIsOneFormOfAllMaps)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng, 400);
        const SquaresForm form = SquaresForm::ofL2(s.rays);
        for (int i = 0; i < 3; ++i) {
            const PlaneWarp map = anyMap(rng, s.rays);
            const double expected = lixelEnergy(LixelMetric::L2, s.rays, map);
            EXPECT_NEAR(squaresOf(form, map), expected, 1e-12 * expected);
        }
    });
}

TEST(LixelEnergy, OfAreasIsOneFormOfAllMaps)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng, 400);
        const CubesForm form(s.rays);
        for (int i = 0; i < 3; ++i) {
            const PlaneWarp map = anyMap(rng, s.rays);
            const double expected = lixelEnergy(LixelMetric::Area, s.rays, map);
            // Areas of long and thin lixels, as differences of products, are rounded by as much as these.
            const double rounded = expected + lixelEnergy(LixelMetric::L2, s.rays, map);
            EXPECT_NEAR(form.at(map.w) / std::abs(dot(map.x, cross(map.y, map.w))), expected, 1e-12 * rounded);
        }
    });
}

// At its own map the form divides squares by their roots: for Lloyd's m, the root of all four derivatives' squares, which is m where
// lixels are lines and sqrt(2) m where they are round; for the width |a| + |b| of two sides, (a^2 + b^2) / (|a| + |b|), which is the
// width where one is along the edge and half of it where both are alike.
TEST(SquaresForm, NearIsWithinItsBoundsOfTheMetric)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        std::vector<double> room;
        const auto near = [&](LixelMetric metric) {
            return squaresOf(SquaresForm::near(metric, s.rays, map, room), map);
        };
        const double m = lixelEnergy(LixelMetric::Lloyd, s.rays, map),
                     width = lixelEnergy(LixelMetric::Width, s.rays, map);
        EXPECT_GE(near(LixelMetric::Lloyd), m * (1 - 1e-12));
        EXPECT_LE(near(LixelMetric::Lloyd), std::sqrt(2) * m * (1 + 1e-12));
        EXPECT_LE(near(LixelMetric::Width), width * (1 + 1e-12));
        EXPECT_GE(near(LixelMetric::Width), 0.5 * width * (1 - 1e-12));
        std::vector<double> bad;
        badnesses(s.rays, map, bad);
        double roots = 0;
        for (std::size_t i = 0; i < bad.size(); ++i) roots += s.rays.weight[i] * std::sqrt(bad[i]);
        EXPECT_NEAR(near(LixelMetric::Lloyd), roots, 1e-10 * roots);
    });
}

// ---- laws

// A map of n lixels each way: lengths go with 1 / n, squares and areas with 1 / n^2, and the rows' common scale says nothing.
TEST(LixelEnergy, FallsWithTheLixelsOfTheMap)
{
    forEachCase(kCases, [&](Rng& rng) {
        const EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        const double n = rng.logUniform(1e-3, 1e3), c = rng.logUniform(1e-3, 1e3);
        const PlaneWarp finer{n * map.x, n * map.y, map.w}, scaled{c * map.x, c * map.y, c * map.w};
        for (const LixelMetric metric : kAllMetrics) {
            const double energy = lixelEnergy(metric, s.rays, map);
            const int power = metric == LixelMetric::L2 || metric == LixelMetric::Area ? 2 : 1;
            EXPECT_NEAR(lixelEnergy(metric, s.rays, finer) * std::pow(n, power), energy, 1e-11 * energy);
            EXPECT_NEAR(lixelEnergy(metric, s.rays, scaled), energy, 1e-11 * energy);
            // So h does not change along w, the rows moving with it (Euler).
            const EnergyChange change = lixelEnergyChange(metric, s.rays, map);
            EXPECT_NEAR(dot(change.withW, map.w), power * energy,
                        1e-9 * (energy + length(change.withW) * length(map.w)));
        }
    });
}

TEST(LixelEnergy, KnowsNoOrderOfSamplesAndNoScaleOfWeights)
{
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        std::array<double, 4> before{};
        for (std::size_t i = 0; i < 4; ++i) before[i] = lixelEnergy(kAllMetrics[i], s.rays, map);
        for (std::size_t i = s.samples.size(); i > 1; --i)
            std::swap(s.samples[i - 1], s.samples[std::size_t(rng.integer(0, int(i) - 1))]);
        for (NeedSample& sample : s.samples) sample.weight *= 1e5;
        s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(lixelEnergy(kAllMetrics[i], s.rays, map), before[i], 1e-12 * before[i]);
    });
}

// The light plane may be turned, mirrored or seen along another axis: rays and rows change, lixels do not.
TEST(LixelEnergy, IsTheSameInEveryFrameOfTheLight)
{
    forEachCase(kCases, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        const PlaneWarp map = anyMap(rng, s.rays);
        // Another frame's rays are A r; rows on them are those on r, times A's inverse. All rays stay before it.
        const PlaneWarp a = anyMap(rng, s.rays);
        const DualBasis columns = dualBasis(a);
        const auto there = [&](Vec3d row) {
            return Vec3d{dot(row, columns.b1), dot(row, columns.b2), dot(row, columns.a)};
        };
        const PlaneWarp mapThere{there(map.x), there(map.y), there(map.w)};
        Mat4d framed = s.frame.framedFromLocal;
        const auto row = [&](Vec3d r) {
            return r.x * s.frame.framedFromLocal.row(0) + r.y * s.frame.framedFromLocal.row(1) +
                   r.z * s.frame.framedFromLocal.row(3);
        };
        framed.setRow(0, row(a.x)), framed.setRow(1, row(a.y)), framed.setRow(3, row(a.w));
        EdgeRays rays;
        rays.assign(s.view, s.originWorld, framed, s.samples);
        ASSERT_EQ(rays.size(), s.rays.size());
        for (const LixelMetric metric : kAllMetrics) {
            const double energy = lixelEnergy(metric, s.rays, map);
            EXPECT_NEAR(lixelEnergy(metric, rays, mapThere), energy, 1e-9 * energy) << nameOf(metric);
        }
    });
}

TEST(LixelEnergy, IsTheSameFarFromTheWorldsOrigin)
{
    forEachCase(kCases / 4, [&](Rng& rng) {
        const std::uint64_t seed = rng.bits();
        Rng here(seed), there(seed);
        const EdgeScene near = anyEdgeScene(here), far = anyEdgeScene(there, 40, {1e5, -2e5, 1e5});
        const PlaneWarp map = anyMap(here, near.rays);
        if (near.samples.size() != far.samples.size()) return; // a normal was next to edge-on
        for (const LixelMetric metric : kAllMetrics) {
            const double energy = lixelEnergy(metric, near.rays, map);
            EXPECT_NEAR(lixelEnergy(metric, far.rays, map), energy, 1e-6 * energy) << nameOf(metric);
        }
    });
}

// ---- some of the samples

TEST(EdgeRays, SomeOfThemAreAsManyAndStandForAll)
{
    forEachCase(20, [&](Rng& rng) {
        EdgeScene s = anyEdgeScene(rng);
        while (s.samples.size() < 8000)
            s.samples.push_back(s.samples[std::size_t(rng.integer(0, 7)) % s.samples.size()]);
        // Most weigh next to nothing, as those away from shadows do.
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            s.samples[i].weight = i % 8 == 0 ? rng.uniform(0.5, 1) : 0.002;
            if (i % 3 == 0) s.samples[i].across = {};
        }
        s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
        EdgeRays some;
        some.assignSome(s.rays, 2000);
        EXPECT_LE(some.size(), 2000u);
        EXPECT_GT(some.size(), 800u); // no sample that weighs something is taken but as often as it does
        EXPECT_NEAR(std::accumulate(some.weight.begin(), some.weight.end(), 0.0), 1, 1e-12);
        EXPECT_NEAR(std::accumulate(some.edgeWeight.begin(), some.edgeWeight.end(), 0.0), 1, 1e-12);
        const PlaneWarp map = anyMap(rng, s.rays);
        for (const LixelMetric metric : kAllMetrics) {
            const double all = lixelEnergy(metric, s.rays, map);
            EXPECT_NEAR(lixelEnergy(metric, some, map), all, 0.1 * all) << nameOf(metric);
        }
        some.assignSome(s.rays, s.rays.edgeWeight.size());
        for (const LixelMetric metric : kAllMetrics) {
            const double all = lixelEnergy(metric, s.rays, map);
            EXPECT_NEAR(lixelEnergy(metric, some, map), all, 1e-12 * all) << nameOf(metric);
        }
    });
}

// Edges of unknown direction are four in a row: taking every fourth, or every eighth, must not take one direction alone.
TEST(EdgeRays, SomeOfThemHaveAllDirections)
{
    Rng rng(5);
    for (const std::size_t count : {320u, 640u, 1280u, 2560u, 5120u}) {
        EdgeScene s = anyEdgeScene(rng, 1);
        s.samples[0].across = {};
        s.samples.resize(count, s.samples[0]);
        s.rays.assign(s.view, s.originWorld, s.frame.framedFromLocal, s.samples);
        EdgeRays some;
        some.assignSome(s.rays, 640);
        const PlaneWarp map = anyMap(rng, s.rays);
        const double all = lixelEnergy(LixelMetric::Width, s.rays, map);
        EXPECT_NEAR(lixelEnergy(LixelMetric::Width, some, map), all, 0.02 * all) << count;
    }
}

} // namespace
} // namespace lixel
