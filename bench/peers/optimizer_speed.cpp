// SPDX-License-Identifier: MIT
// The search for the best light image against general optimisers, in one run and on one thread: 180 x 180 samples of one light, the
// same start. A peer is done when it first comes within 1 % of the energy that searchWidely() ends with.
#include "peers/axis_problem.h"
#include "plan/search_cases.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#if LIXEL_HAS_NLOPT
#include <nlopt.hpp>
#endif
#if LIXEL_HAS_CERES
#include <ceres/ceres.h>
#endif

namespace lixel::bench {
namespace {

constexpr std::size_t kSamples = 180 * 180;
constexpr int kMostEvaluations = 400;
constexpr double kNearEnough = 1.01;

// The searched case with just so many samples: those of a finer picture, evenly.
bool makeCase(std::uint64_t seed, std::size_t count, test::SearchCase& c)
{
    test::Rng rng(seed);
    const int height = int(std::sqrt(double(count) * 2.2)), width = height * 4 / 3;
    if (!c.make(rng, width, height) || c.edges.size() < count) return false;
    std::vector<NeedSample> some;
    for (std::size_t i = 0; i < count; ++i) some.push_back(c.edges[(2 * i + 1) * c.edges.size() / (2 * count)]);
    c.edges = some;
    c.rays.assign(c.setup.view, c.setup.originWorld, c.frame.framedFromLocal, c.edges);
    return c.rays.size() == count;
}

struct Ours
{
    double seconds = 0, energy = 0;
};

// The median of some runs, without and with what makes rays of samples.
Ours timeOurs(test::SearchCase& c, LixelMetric metric, double& withRays)
{
    std::array<double, 5> alone{}, whole{};
    Ours out;
    for (std::size_t i = 0; i < alone.size(); ++i) {
        const auto start = std::chrono::steady_clock::now();
        c.rays.assign(c.setup.view, c.setup.originWorld, c.frame.framedFromLocal, c.edges);
        const double rays = secondsSince(start);
        out.energy = searchWidely(c.question(metric)).energy;
        whole[i] = secondsSince(start), alone[i] = whole[i] - rays;
    }
    std::sort(alone.begin(), alone.end()), std::sort(whole.begin(), whole.end());
    withRays = whole[whole.size() / 2];
    out.seconds = alone[alone.size() / 2];
    return out;
}

#if LIXEL_HAS_NLOPT
double byNlopt(const std::vector<double>& x, std::vector<double>& slope, void* problem)
{
    Vec2d by;
    const double energy = static_cast<AxisProblem*>(problem)->energy({x[0], x[1]}, slope.empty() ? nullptr : &by);
    if (!slope.empty()) slope = {by.x, by.y};
    return energy;
}

void runNlopt(AxisProblem& problem, nlopt::algorithm algorithm)
{
    nlopt::opt opt(algorithm, 2);
    opt.set_min_objective(byNlopt, &problem);
    opt.set_lower_bounds(-20), opt.set_upper_bounds(20);
    opt.set_initial_step(0.2);
    opt.set_maxeval(kMostEvaluations);
    opt.set_xtol_abs(1e-7);
    std::vector<double> x{0, 0};
    double energy = 0;
    problem.start();
    try {
        opt.optimize(x, energy);
    } catch (const std::exception&) { // at the limit of rounding; what was reached counts
    }
}
#endif

#if LIXEL_HAS_CERES
class ForCeres : public ceres::FirstOrderFunction
{
public:
    explicit ForCeres(AxisProblem& problem) : problem_(problem) {}
    bool Evaluate(const double* x, double* cost, double* gradient) const override
    {
        Vec2d by;
        *cost = problem_.energy({x[0], x[1]}, gradient ? &by : nullptr);
        if (gradient) gradient[0] = by.x, gradient[1] = by.y;
        return *cost < AxisProblem::kInfeasible;
    }
    int NumParameters() const override { return 2; }

private:
    AxisProblem& problem_;
};

void runCeres(AxisProblem& problem, ceres::LineSearchDirectionType direction)
{
    ceres::GradientProblem gradient(new ForCeres(problem));
    ceres::GradientProblemSolver::Options options;
    options.line_search_direction_type = direction;
    options.max_num_iterations = kMostEvaluations;
    options.function_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    ceres::GradientProblemSolver::Summary summary;
    double x[] = {0, 0};
    problem.start();
    ceres::Solve(options, gradient, x, &summary);
}
#endif

struct Peer
{
    std::string name;
    void (*run)(AxisProblem&);
};

std::vector<Peer> peers()
{
    return
    {
#if LIXEL_HAS_NLOPT
        {"NLopt LBFGS", [](AxisProblem& p) { runNlopt(p, nlopt::LD_LBFGS); }},
            {"NLopt SLSQP", [](AxisProblem& p) { runNlopt(p, nlopt::LD_SLSQP); }},
            {"NLopt MMA", [](AxisProblem& p) { runNlopt(p, nlopt::LD_MMA); }},
            {"NLopt TNEWTON", [](AxisProblem& p) { runNlopt(p, nlopt::LD_TNEWTON_PRECOND_RESTART); }},
            {"NLopt BOBYQA", [](AxisProblem& p) { runNlopt(p, nlopt::LN_BOBYQA); }},
            {"NLopt NELDERMEAD", [](AxisProblem& p) { runNlopt(p, nlopt::LN_NELDERMEAD); }},
#endif
#if LIXEL_HAS_CERES
            {"Ceres LBFGS", [](AxisProblem& p) { runCeres(p, ceres::LBFGS); }},
            {"Ceres BFGS", [](AxisProblem& p) { runCeres(p, ceres::BFGS); }},
            {"Ceres CG", [](AxisProblem& p) { runCeres(p, ceres::NONLINEAR_CONJUGATE_GRADIENT); }},
#endif
    };
}

// Its gradient is what central differences say, away from where rectangles take turns.
double gradientError(test::SearchCase& c, LixelMetric metric)
{
    const MapQuestion question = c.question(metric);
    AxisProblem problem(question, 0);
    constexpr double h = 1e-6;
    const Vec2d p{0.031, -0.017};
    Vec2d slope;
    problem.energy(p, &slope);
    const auto along = [&](Vec2d step) {
        return (problem.energy(p + step, nullptr) - problem.energy(p - step, nullptr)) / (2 * h);
    };
    return length(slope - Vec2d{along({h, 0}), along({0, h})}) / length(slope);
}

void compare(LixelMetric metric, int cases)
{
    const std::vector<Peer> all = peers();
    std::printf("\n%s: seconds until within 1 %% of the wide search's energy (- : never), %zu samples\n",
                std::string(nameOf(metric)).c_str(), kSamples);
    std::printf("%-10s %10s %10s %9s", "seed", "ours", "with rays", "gradient");
    for (const Peer& peer : all) std::printf(" %16s", peer.name.c_str());
    std::printf(" %12s\n", "best / ours");
    std::vector<double> ratios;
    int never = 0;
    for (std::uint64_t seed = 1; int(ratios.size()) + never < cases && seed < 1000; ++seed) {
        test::SearchCase c;
        if (!makeCase(seed, kSamples, c)) continue;
        double withRays = 0;
        const Ours ours = timeOurs(c, metric, withRays);
        std::printf("%-10llu %10.5f %10.5f %9.1e", static_cast<unsigned long long>(seed), ours.seconds, withRays,
                    gradientError(c, metric));
        double best = INFINITY;
        const MapQuestion question = c.question(metric);
        for (const Peer& peer : all) {
            AxisProblem problem(question, kNearEnough * ours.energy);
            peer.run(problem);
            const double seconds = problem.secondsToTarget();
            if (seconds < 0) {
                std::printf(" %9s %5.2fx", "-", problem.least() / ours.energy);
                continue;
            }
            std::printf(" %10.5f %4dx", seconds, problem.evaluations());
            best = std::min(best, seconds);
        }
        if (best < INFINITY) {
            ratios.push_back(best / ours.seconds);
            std::printf(" %12.2f\n", ratios.back());
        } else {
            ++never;
            std::printf(" %12s\n", "none");
        }
        std::fflush(stdout);
    }
    std::sort(ratios.begin(), ratios.end());
    if (!ratios.empty())
        std::printf("best peer / ours: least %.2f, median %.2f of %zu; no peer came there in %d\n", ratios.front(),
                    ratios[ratios.size() / 2], ratios.size(), never);
}

void showGrowth(LixelMetric metric)
{
    std::printf("\n%s: seconds by number of samples\n", std::string(nameOf(metric)).c_str());
    constexpr std::array<std::size_t, 4> kCounts{90 * 90, 128 * 128, 180 * 180, 255 * 255};
    std::vector<Vec2d> points;
    std::uint64_t seed = 1;
    test::SearchCase largest;
    while (!makeCase(seed, kCounts.back(), largest)) ++seed;
    for (const std::size_t count : kCounts) {
        test::SearchCase c;
        if (!makeCase(seed, count, c)) continue;
        double withRays = 0;
        const double seconds = timeOurs(c, metric, withRays).seconds;
        std::printf("%8zu %10.5f with rays %10.5f\n", count, seconds, withRays);
        points.push_back({std::log(double(count)), std::log(withRays)});
    }
    if (points.size() > 1)
        std::printf("exponent %.2f\n", (points.back().y - points.front().y) / (points.back().x - points.front().x));
}

} // namespace
} // namespace lixel::bench

int main(int argc, char** argv)
{
    const int cases = argc > 1 ? std::atoi(argv[1]) : 10;
    const std::string only = argc > 2 ? argv[2] : "";
    for (const lixel::LixelMetric metric : {lixel::LixelMetric::L2, lixel::LixelMetric::Width}) {
        if (!only.empty() && only != lixel::nameOf(metric)) continue;
        lixel::bench::compare(metric, cases);
        lixel::bench::showGrowth(metric);
    }
}
