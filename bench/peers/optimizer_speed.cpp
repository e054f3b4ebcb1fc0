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

// Least squares as Ceres has them: a block of four residuals a sample, the derivatives of its place, by formulas.
class SquaresOfSample : public ceres::SizedCostFunction<4, 2>
{
public:
    SquaresOfSample(const EdgeRays& rays, std::size_t i, const std::optional<AxisProblem::Basis>& basis)
        : rays_(rays), i_(i), basis_(basis)
    {
    }
    bool Evaluate(const double* const*, double* residuals, double** jacobians) const override
    {
        if (!basis_) return false;
        const Vec3d r = at(rays_.ray), k[] = {at(rays_.first), at(rays_.second)};
        const double root = std::sqrt(rays_.weight[i_]), wr = dot(basis_->w, r);
        for (std::size_t n = 0; n < 4; ++n) {
            const Vec3d b = n < 2 ? basis_->b1 : basis_->b2;
            residuals[n] = root * wr * dot(k[n % 2], b);
            for (std::size_t by = 0; jacobians && jacobians[0] && by < 2; ++by) {
                const Vec3d bBy = n < 2 ? basis_->b1By[by] : basis_->b2By[by];
                jacobians[0][2 * n + by] =
                    root * (dot(basis_->wBy[by], r) * dot(k[n % 2], b) + wr * dot(k[n % 2], bBy));
            }
        }
        return true;
    }

private:
    Vec3d at(const EdgeRays::Vectors& v) const { return {v[0][i_], v[1][i_], v[2][i_]}; }

    const EdgeRays& rays_;
    std::size_t i_;
    const std::optional<AxisProblem::Basis>& basis_;
};

// The rectangle of each axis that is tried.
class BasisOfEach : public ceres::EvaluationCallback
{
public:
    BasisOfEach(AxisProblem& problem, const double* x) : problem_(problem), x_(x) {}
    void PrepareForEvaluation(bool, bool isNewPoint) override
    {
        if (isNewPoint) basis = problem_.basisAt({x_[0], x_[1]});
    }

    std::optional<AxisProblem::Basis> basis;

private:
    AxisProblem& problem_;
    const double* x_;
};

class NoteEnergy : public ceres::IterationCallback
{
public:
    explicit NoteEnergy(AxisProblem& problem) : problem_(problem) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override
    {
        problem_.note(2 * summary.cost);
        return ceres::SOLVER_CONTINUE;
    }

private:
    AxisProblem& problem_;
};

void runLeastSquares(AxisProblem& problem)
{
    double x[] = {0, 0};
    BasisOfEach basis(problem, x);
    ceres::Problem::Options problemOptions;
    problemOptions.evaluation_callback = &basis;
    ceres::Problem squares(problemOptions);
    for (std::size_t i = 0; i < problem.rays().size(); ++i)
        squares.AddResidualBlock(new SquaresOfSample(problem.rays(), i, basis.basis), nullptr, x);
    NoteEnergy note(problem);
    ceres::Solver::Options options;
    options.max_num_iterations = kMostEvaluations;
    options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    options.function_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    options.callbacks.push_back(&note);
    ceres::Solver::Summary summary;
    problem.start();
    ceres::Solve(options, &squares, &summary);
}
#endif

struct Peer
{
    std::string name;
    void (*run)(AxisProblem&);
    bool isOfBlocks = false; // sees squares sample by sample, not their sum in vector code
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
            {"Ceres LM blocks", runLeastSquares, true},
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

// Ratios of times, peer over ours.
void printRatios(const char* of, std::vector<double> ratios)
{
    if (ratios.empty()) return;
    std::sort(ratios.begin(), ratios.end());
    std::printf("%s / ours: least %.2f, median %.2f of %zu\n", of, ratios.front(), ratios[ratios.size() / 2],
                ratios.size());
}

void compare(LixelMetric metric, int cases)
{
    std::vector<Peer> all = peers();
    if (metric != LixelMetric::L2) std::erase_if(all, [](const Peer& peer) { return peer.isOfBlocks; });
    std::printf("\n%s: seconds until within 1 %% of the wide search's energy (- : never), %zu samples\n",
                std::string(nameOf(metric)).c_str(), kSamples);
    std::printf("%-10s %10s %10s %9s", "seed", "ours", "with rays", "gradient");
    for (const Peer& peer : all) std::printf(" %16s", peer.name.c_str());
    std::printf(" %12s\n", "best / ours");
    std::vector<double> ratios, ofBlocks;
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
            if (peer.isOfBlocks) ofBlocks.push_back(seconds / ours.seconds);
            else best = std::min(best, seconds);
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
    printRatios("best peer with sums in vector code", ratios);
    std::printf("none of these came there in %d\n", never);
    printRatios("blocks of residuals", ofBlocks);
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
