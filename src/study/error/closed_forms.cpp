// SPDX-License-Identifier: MIT
#include "study/error/closed_forms.hpp"

#include "simulation/engine/make_engine.hpp"
#include "simulation/motion/drop_and_roll.hpp"
#include "simulation/motion/fall_index.hpp"
#include "simulation/motion/free_flight.hpp"
#include "simulation/solver/position_solver.hpp"
#include "study/stability/stress_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace frostfill
{
namespace
{

// Everything here is in units of the run: r = 1, g = 1.
// The paper's method bounces and rests as well as its step lets it; nothing is promised.
constexpr double kNotFrozen = 1e-9; // from its place, of a sphere at rest that still runs [r]
constexpr double kStepsToRest = 10; // whose bounces are lost at the end of a bouncing
constexpr double kNoClaim = std::numeric_limits<double>::infinity();

Scene unitScene(Preset preset, Integrator integrator = Integrator::explicitEuler)
{
    Scene scene = presetScene(preset, "torus");
    scene.spheres.radius = 1;
    scene.spheres.count = 1;
    scene.spheres.groupSize = 1;
    scene.motion.integrator = integrator;
    scene.motion.gravity = 1;
    scene.motion.restitution = 0;
    return scene;
}

/// A room of our own: sphere and gravity have size 1, and its centre is the origin.
std::unique_ptr<World> room(const TriangleMesh& mesh, const Scene& scene = unitScene(Preset::fast))
{
    return std::make_unique<World>(scene, mesh);
}

TriangleMesh hall(double half, double height, int cuts = 2)
{
    return boxMesh({-half, -height / 2, -half}, {half, height / 2, half}, cuts);
}

/// A flight that loses nothing by itself.
FreeFlight::Settings lossless(double restitution)
{
    FreeFlight::Settings settings;
    settings.restitution = restitution;
    settings.damping = 0;
    settings.bounceSpeed = 0;
    return settings;
}

class ClosedForms
{
public:
    explicit ClosedForms(bool quick) : quick_(quick) {}

    std::vector<ClosedFormPoint> run()
    {
        for (const double dt : {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001})
        {
            freeFall(dt);
            throwing(dt);
            bounce(dt);
            bounceToRest(dt);
            headOn(dt);
        }
        for (const int cuts : {1, 3, 10, quick_ ? 20 : 100})
        {
            incline(cuts);
        }
        for (const int segments : {24, 48, 96, quick_ ? 96 : 192})
        {
            bowl(segments, 0.005);
        }
        grooves();
        cones();
        corner();
        threeSpheres();
        return std::move(points_);
    }

private:
    void add(const char* problem, const char* method, const char* parameter, double value,
             double error, double allowed)
    {
        points_.push_back({problem, method, parameter, value, error, allowed, false});
    }

    // Closed form after N steps of dt, T = N dt: semi-implicit Euler falls T dt / 2 too far,
    // explicit Euler as much too little, the exact step neither.
    void freeFall(double dt)
    {
        constexpr double kTime = 5;
        const int steps = static_cast<int>(std::lround(kTime / dt));
        for (const bool isExplicit : {true, false})
        {
            Scene scene = unitScene(Preset::paper, isExplicit ? Integrator::explicitEuler
                                                              : Integrator::semiImplicitEuler);
            scene.motion.dt = dt;
            const auto world = room(hall(5, 60), scene);
            const auto engine = makeEngine(*world);
            const PlacedSphere one{{0, 20, 0}, 1};
            engine->releaseAt({&one, 1});
            for (int step = 0; step < steps; ++step)
            {
                engine->step();
            }
            const double error = world->spheres.y[0] - (20 - kTime * kTime / 2);
            points_.push_back({"free fall", isExplicit ? "explicit Euler" : "semi-implicit Euler",
                               "step", dt, error, (isExplicit ? 1 : -1) * kTime * dt / 2, true});
        }
        const auto world = room(hall(5, 60));
        const FreeFlight flight(*world, lossless(0));
        Runner runner;
        runner.restart(0, {0, 20, 0}, 1);
        for (int step = 0; step < steps; ++step)
        {
            flight.advance(runner, dt);
        }
        points_.push_back({"free fall", "exact step", "step", dt,
                           runner.position.y() - (20 - kTime * kTime / 2), 0, true});
    }

    void throwing(double dt)
    {
        const auto world = room(hall(20, 60));
        const FreeFlight flight(*world, lossless(0));
        Runner runner;
        runner.restart(0, {0, 0, 0}, 1);
        runner.velocity = {1.5, 4, -0.5};
        const int steps = static_cast<int>(std::lround(8 / dt));
        double worst = 0;
        for (int step = 1; step <= steps; ++step)
        {
            flight.advance(runner, dt);
            const double t = step * dt;
            const Eigen::Vector3d expected(1.5 * t, 4 * t - t * t / 2, -0.5 * t);
            worst = std::max(worst, (runner.position - expected).norm());
        }
        add("throw", "exact step", "step", dt, worst, 1e-12 * steps + 1e-12);
    }

    // Apex after the first bounce: e^2 h.
    void bounce(double dt)
    {
        constexpr double kDrop = 10;
        constexpr double kRestitution = 0.7;
        const double expected = kRestitution * kRestitution * kDrop;
        const auto apexOf = [&](auto&& advance)
        {
            // advance() returns height above rest and vertical speed.
            bool bounced = false;
            double apex = 0;
            for (int step = 0; step < 1000000; ++step)
            {
                const auto [height, speed] = advance();
                bounced = bounced || speed > 0;
                if (bounced)
                {
                    apex = std::max(apex, height + (speed > 0 ? speed * speed / 2 : 0));
                }
                if (bounced && speed < 0)
                {
                    break;
                }
            }
            return apex;
        };
        const auto world = room(hall(5, 60));
        const FreeFlight flight(*world, lossless(kRestitution));
        Runner runner;
        runner.restart(0, {0.3, -29 + kDrop, 0.2}, 1);
        const double ours = apexOf(
            [&]
            {
                flight.advance(runner, dt);
                return std::pair(runner.position.y() + 29, runner.velocity.y());
            });
        add("bounce", "exact step", "step", dt, ours / expected - 1,
            0.6 * dt + kClosedFormRounding);
        for (const bool isExplicit : {true, false})
        {
            Scene scene = unitScene(Preset::paper, isExplicit ? Integrator::explicitEuler
                                                              : Integrator::semiImplicitEuler);
            scene.motion.dt = dt;
            scene.motion.restitution = kRestitution;
            const auto hallOfPaper = room(hall(5, 60), scene);
            const auto engine = makeEngine(*hallOfPaper);
            const PlacedSphere one{{0.3, -29 + kDrop, 0.2}, 1};
            engine->releaseAt({&one, 1});
            const double apex = apexOf(
                [&]
                {
                    engine->step();
                    return std::pair(hallOfPaper->spheres.y[0] + 29,
                                     hallOfPaper->spheres.velocity(0).y());
                });
            add("bounce", isExplicit ? "explicit Euler" : "semi-implicit Euler", "step", dt,
                apex / expected - 1, kNoClaim);
        }
    }

    // At rest after sqrt(2 h / g) (1 + e) / (1 - e), infinitely many bounces later.
    void bounceToRest(double dt)
    {
        constexpr double kDrop = 10;
        constexpr double kRestitution = 0.7;
        const double expected = std::sqrt(2 * kDrop) * (1 + kRestitution) / (1 - kRestitution);
        const auto world = room(hall(5, 60));
        const FreeFlight flight(*world, lossless(kRestitution));
        Runner runner;
        runner.restart(0, {0.3, -29 + kDrop, 0.2}, 1);
        constexpr double kLow = 1e-6;
        double lastMotion = 0;
        for (double t = dt; t < 2 * expected; t += dt)
        {
            flight.advance(runner, dt);
            if (runner.position.y() + 29 > kLow)
            {
                lastMotion = t;
            }
        }
        // Bounces that take less than a step are not told apart, and those below the height at
        // which they are no longer looked at are left out.
        const double tail = std::sqrt(8 * kLow) / (1 - kRestitution);
        add("bounce to rest", "exact step", "step", dt, lastMotion / expected - 1,
            (kStepsToRest * dt + tail) / expected);
    }

    // Two equal spheres meet head on: v1' = v (1 - e) / 2, v2' = v (1 + e) / 2.
    void headOn(double dt)
    {
        constexpr double kRestitution = 0.6;
        constexpr double kSpeed = 2;
        Scene scene = unitScene(Preset::fast);
        const auto world = room(hall(20, 60), scene);
        world->pull.uniform.setZero(); // weightless, so that the closed form holds
        const FreeFlight flight(*world, lossless(kRestitution));
        Threads threads(1);
        RunnerGrid grid(world->resting.frame());
        PositionSolver positionSolver(grid, flight, threads,
                                      {.restitution = kRestitution, .bounceSpeed = 0});
        std::vector<Runner> pair(2);
        pair[0].restart(0, {-3, 0, 0}, 1);
        pair[1].restart(1, {1, 0, 0}, 1);
        pair[0].velocity = {kSpeed, 0, 0};
        for (double t = 0; t < 4; t += dt)
        {
            for (Runner& runner : pair)
            {
                flight.advance(runner, dt);
            }
            positionSolver.resolve(pair, dt);
        }
        const double error =
            std::max(std::abs(pair[0].velocity.x() - kSpeed * (1 - kRestitution) / 2),
                     std::abs(pair[1].velocity.x() - kSpeed * (1 + kRestitution) / 2));
        add("head-on pair", "exact step", "step", dt, error, 1e-9);
    }

    // Sliding down a slope: g sin a, however finely it is cut. The room is tilted.
    void incline(int cuts)
    {
        constexpr double kAngle = 0.35;
        constexpr double kTime = 8;
        const Eigen::Matrix3d tilt =
            Eigen::AngleAxisd(kAngle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
        const TriangleMesh mesh =
            moved(boxMesh({-30, -6, -12}, {30, 6, 12}, cuts), 1, tilt, Eigen::Vector3d::Zero());
        const auto world = room(mesh);
        const FreeFlight flight(*world, lossless(0));
        Runner runner;
        const Eigen::Vector3d start = tilt * Eigen::Vector3d(15, -5, 0.7);
        runner.restart(0, start, 1);
        const int steps = 80;
        for (int step = 0; step < steps; ++step)
        {
            flight.advance(runner, kTime / steps);
        }
        const Eigen::Vector3d expected =
            start - tilt * Eigen::Vector3d(std::sin(kAngle) * kTime * kTime / 2, 0, 0);
        add("incline", "exact step", "triangles", 2.0 * cuts * cuts,
            (runner.position - expected).norm(), 1e-9);
    }

    // A ball in a bowl swings with T = 2 pi sqrt(R - r), small amplitude.
    void bowl(int segments, double dt)
    {
        constexpr double kBowl = 30;
        const double expected = 2 * std::numbers::pi * std::sqrt(kBowl - 1);
        TriangleMesh mesh;
        const int rings = segments / 2;
        mesh.vertices.emplace_back(0, 0, -kBowl);
        for (int i = 1; i < rings; ++i)
        {
            for (int j = 0; j < segments; ++j)
            {
                const double a = std::numbers::pi * i / rings;
                const double b = 2 * std::numbers::pi * j / segments;
                // The poles are at the sides, so that the ball swings over regular rows.
                mesh.vertices.emplace_back(kBowl * std::sin(a) * std::sin(b),
                                           -kBowl * std::sin(a) * std::cos(b),
                                           -kBowl * std::cos(a));
            }
        }
        mesh.vertices.emplace_back(0, 0, kBowl);
        const auto at = [&](int i, int j)
        {
            if (i == 0)
            {
                return std::uint32_t{0};
            }
            if (i == rings)
            {
                return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
            }
            return static_cast<std::uint32_t>(1 + (i - 1) * segments + j % segments);
        };
        for (int i = 0; i < rings; ++i)
        {
            for (int j = 0; j < segments; ++j)
            {
                if (i > 0)
                {
                    mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
                }
                if (i + 1 < rings)
                {
                    mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
                }
            }
        }
        if (signedVolume(mesh) < 0)
        {
            mesh = insideOut(mesh);
        }
        const auto world = room(mesh);
        const FreeFlight flight(*world, lossless(0));
        Runner runner;
        constexpr double kAmplitude = 0.35; // [rad] several triangles wide
        const double path = kBowl - 1.2;
        runner.restart(0, {path * std::sin(kAmplitude), -path * std::cos(kAmplitude), 0.01}, 1);
        std::vector<double> crossings;
        for (double t = 0; t < 100 && crossings.size() < 3; t += dt)
        {
            const double before = runner.position.x();
            flight.advance(runner, dt);
            const double now = runner.position.x();
            if ((before > 0) != (now > 0))
            {
                crossings.push_back(t + dt * before / (before - now));
            }
        }
        // T(A) = T0 (1 + A^2 / 16 + 11 A^4 / 3072): the ball loses amplitude at every crease, so
        // only the first quarter and half swing are used.
        const double a2 = kAmplitude * kAmplitude;
        const double swing = expected * (1 + a2 / 16 + 11 * a2 * a2 / 3072);
        const double half = crossings.size() > 1 ? crossings[1] - crossings[0] : 0;
        // On facets that turn by d the potential is linear between points of the parabola, from
        // which it differs by up to g (R - r) d^2 / 8: a share (d / 2A)^2 of the swing's energy.
        // How much of the amplitude the creases leave is not known either.
        const double turn = 2 * std::numbers::pi / segments;
        const double allowed = std::pow(turn / (2 * kAmplitude), 2) + a2 / 16;
        add("bowl", "exact step", "segments", segments, half / (swing / 2) - 1, allowed);
    }

    // The places that our own engine freezes at, and those of the paper's.
    double restingError(Preset preset, const TriangleMesh& mesh, const Eigen::Vector3d& start,
                        const Eigen::Vector3d& expected)
    {
        Scene scene = unitScene(preset, Integrator::semiImplicitEuler);
        scene.freezing.setTimeLimit = 600;
        const auto world = room(mesh, scene);
        const auto engine = makeEngine(*world);
        const PlacedSphere one{start, 1};
        engine->releaseAt({&one, 1});
        while (engine->step())
        {
        }
        return (world->spheres.position(0) - expected).head<2>().norm();
    }

    // The same without freezing: where a sphere that runs comes to lie.
    static double runningError(const TriangleMesh& mesh, const Eigen::Vector3d& start,
                               const Eigen::Vector3d& expected)
    {
        const auto world = room(mesh);
        FreeFlight::Settings settings;
        settings.restitution = 0;
        const FreeFlight flight(*world, settings);
        Runner runner;
        runner.restart(0, start, 1);
        for (int step = 0; step < 2000; ++step)
        {
            flight.advance(runner, 0.1);
        }
        return (runner.position - expected).head<2>().norm();
    }

    void addFast(const char* problem, const char* parameter, double value, const TriangleMesh& mesh,
                 const Eigen::Vector3d& start, const Eigen::Vector3d& expected)
    {
        add(problem, "fast", parameter, value, restingError(Preset::fast, mesh, start, expected),
            1e-7);
        add(problem, "fast, not frozen", parameter, value, runningError(mesh, start, expected),
            kNotFrozen);
    }

    // r / sin a above the tip of a cone of half angle a, of which the mesh is a pyramid that
    // touches it from outside.
    void cones()
    {
        constexpr int kSides = 12;
        constexpr double kHeight = 12;
        for (const double angle : {0.3, 0.6, 0.9})
        {
            const double ring = kHeight * std::tan(angle) / std::cos(std::numbers::pi / kSides);
            TriangleMesh mesh;
            mesh.vertices.emplace_back(0, -kHeight / 2, 0);
            mesh.vertices.emplace_back(0, kHeight / 2, 0);
            for (int k = 0; k < kSides; ++k)
            {
                const double a = 2 * std::numbers::pi * k / kSides;
                mesh.vertices.emplace_back(ring * std::cos(a), kHeight / 2, ring * std::sin(a));
            }
            for (std::uint32_t k = 0; k < kSides; ++k)
            {
                const std::uint32_t a = 2 + k;
                const std::uint32_t b = 2 + (k + 1) % kSides;
                mesh.triangles.push_back({0, a, b});
                mesh.triangles.push_back({1, b, a});
            }
            if (signedVolume(mesh) < 0)
            {
                mesh = insideOut(mesh);
            }
            const Eigen::Vector3d expected(0, -kHeight / 2 + 1 / std::sin(angle), 0);
            const Eigen::Vector3d start(0.1, 2.4, 0.1);
            const double degrees = angle * 180 / std::numbers::pi;
            addFast("cone", "half angle", degrees, mesh, start, expected);
        }
    }

    // r / sin a above the bottom of a groove of half angle a.
    void grooves()
    {
        for (const double angle : {0.3, 0.6, 0.9, 1.2})
        {
            const double height = 12;
            const double width = height * std::tan(angle);
            TriangleMesh mesh;
            for (const double z : {-10.0, 10.0})
            {
                mesh.vertices.emplace_back(0, -height / 2, z);
                mesh.vertices.emplace_back(width, height / 2, z);
                mesh.vertices.emplace_back(-width, height / 2, z);
            }
            mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                              {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
            const Eigen::Vector3d expected(0, -height / 2 + 1 / std::sin(angle), 0);
            const Eigen::Vector3d start(0.2, 2.4, 0.4);
            const double degrees = angle * 180 / std::numbers::pi;
            addFast("groove", "half angle", degrees, mesh, start, expected);
            add("groove", "paper", "half angle", degrees,
                restingError(Preset::paper, mesh, start, expected), kNoClaim);
        }
    }

    // In a cube that stands on a corner: sqrt(3) r above it.
    void corner()
    {
        const Eigen::Matrix3d stand =
            Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d(1, 1, 1), Eigen::Vector3d::UnitY())
                .toRotationMatrix();
        const TriangleMesh mesh =
            moved(boxMesh({-5, -5, -5}, {5, 5, 5}, 3), 1, stand, Eigen::Vector3d::Zero());
        const Eigen::Vector3d expected(0, -4 * std::sqrt(3.0), 0);
        const Eigen::Vector3d start(0.3, -2, 0.2);
        addFast("corner", "cuts", 3, mesh, start, expected);
        add("corner", "paper", "cuts", 3, restingError(Preset::paper, mesh, start, expected),
            kNoClaim);
    }

    // On three that touch each other: 2 r sqrt(2/3) above their centres.
    void threeSpheres()
    {
        const auto world = room(boxMesh({-8, -8, -8}, {8, 8, 8}));
        FallIndex falls(world->resting.frame(), world->triangles);
        for (int k = 0; k < 3; ++k)
        {
            const double a = 2 * std::numbers::pi * k / 3;
            const double arm = 2 / std::sqrt(3.0);
            const Eigen::Vector3d p(arm * std::cos(a), -7, arm * std::sin(a));
            world->freeze(world->release(p, 1, 0));
            world->forgetFrozen();
            falls.insert(p);
        }
        DropAndRoll descent(*world, falls);
        Eigen::Vector3d place(0.2, 0, 0.1);
        (void)descent.settle(place, 1);
        const Eigen::Vector3d expected(0, -7 + 2 * std::sqrt(2.0 / 3.0), 0);
        add("on three spheres", "fast", "spheres", 3, (place - expected).norm(), 1e-7);
    }

    bool quick_;
    std::vector<ClosedFormPoint> points_;
};

} // namespace

std::vector<ClosedFormPoint> measureClosedForms(bool quick)
{
    return ClosedForms(quick).run();
}

} // namespace frostfill
