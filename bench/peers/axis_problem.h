// SPDX-License-Identifier: MIT
#pragma once

#include "lixel/plan/fit/hull_map.h"
#include "lixel/plan/fit/lixel_energy.h"
#include "lixel/plan/fit/map_search.h"

#include <array>
#include <chrono>
#include <optional>
#include <vector>

namespace lixel::bench {

inline double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// What a general optimiser is given: the energy of the axis (a, b, 1) with the rectangle that is best for it, the same rectangles as
// searchWidely() has, and its gradient, by formulas. L2 takes two passes over the samples for all rectangles at once; other
// metrics a pass for each rectangle and one more. Remembers when it first came to the target. Square maps; L2 and Width.
class AxisProblem
{
public:
    static constexpr double kInfeasible = 1e30;

    AxisProblem(const MapQuestion& question, double target) : question_(question), target_(target) {}

    void start();
    double energy(Vec2d axis, Vec2d* slope);
    void note(double energy); // that it was reached

    // What the squares of each sample are made of (lixel_energy.h): the row w, unit, and the basis vectors of the best rectangle; and how
    // these change with the axis' two numbers, but for w's length, which no square knows. L2.
    struct Basis
    {
        Vec3d w, b1, b2;
        std::array<Vec3d, 2> wBy, b1By, b2By;
    };
    std::optional<Basis> basisAt(Vec2d axis);

    const EdgeRays& rays() const { return question_.rays; }
    double least() const { return least_; }
    double secondsToTarget() const { return secondsToTarget_; } // negative: not reached
    int evaluations() const { return evaluations_; }

private:
    // With the row w, and with the basis vectors b1 and b2 (lixel_energy.h), as if they were free of each other.
    struct Slopes
    {
        Vec3d withW, withB1, withB2;
    };
    std::size_t bestSide(const HullMaps& hull, double& energy) const;
    Slopes slopesOf(Vec3d w, const HullMaps::Steps& steps) const;

    const MapQuestion& question_;
    double target_;
    std::vector<Vec2d> room_;
    std::chrono::steady_clock::time_point start_;
    double least_ = kInfeasible, secondsToTarget_ = -1;
    int evaluations_ = 0;
};

} // namespace lixel::bench
