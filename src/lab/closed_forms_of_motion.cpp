// SPDX-License-Identifier: MIT
#include "lab/closed_form_parts.hpp"
#include "lab/meshes.hpp"
#include "oracle/motion.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/solver/position_solver.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

/// How spheres move, against closed forms.
namespace frostfill
{
namespace
{

constexpr double kStepsToRest = 10; // whose bounces are lost at the end of a bouncing
// The paper's method bounces as well as its step lets it; nothing is promised.
constexpr double kNoClaimOfMotion = std::numeric_limits<double>::infinity();

/// After the first bounce. advance() returns height above rest and vertical speed.
double apexOf(const std::function<std::pair<double, double>()>& advance)
{
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
}

/// A sphere around the origin, in so many segments.
TriangleMesh bowlMesh(int segments, double radius)
{
    TriangleMesh mesh;
    const int rings = segments / 2;
    mesh.vertices.emplace_back(0, 0, -radius);
    for (int i = 1; i < rings; ++i)
    {
        for (int j = 0; j < segments; ++j)
        {
            const double a = std::numbers::pi * i / rings;
            const double b = 2 * std::numbers::pi * j / segments;
            // The poles are at the sides, so that the ball swings over regular rows.
            mesh.vertices.emplace_back(radius * std::sin(a) * std::sin(b),
                                       -radius * std::sin(a) * std::cos(b), -radius * std::cos(a));
        }
    }
    mesh.vertices.emplace_back(0, 0, radius);
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
    return mesh;
}

} // namespace

// Closed form after N steps of dt, T = N dt: semi-implicit Euler falls T dt / 2 too far,
// explicit Euler as much too little, the exact step neither.
void measureFreeFall(ClosedFormPoints& points, double dt)
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
        const double error = world->spheres.position(0).y() - (20 - oracle::fall(kTime));
        points.addPredicted("free fall", isExplicit ? "explicit Euler" : "semi-implicit Euler",
                            "step", dt, error, (isExplicit ? 1 : -1) * oracle::eulerLag(kTime, dt));
    }
    const auto world = room(hall(5, 60));
    FreeFlight flight(*world, lossless(0));
    world->spheres.add({0, 20, 0}, 1, 0);
    RunningSpheres& running = world->spheres.running();
    for (int step = 0; step < steps; ++step)
    {
        flight.advance(0, dt);
    }
    points.addPredicted("free fall", "exact step", "step", dt,
                        running.position[0].y() - (20 - oracle::fall(kTime)), 0);
}

void measureThrow(ClosedFormPoints& points, double dt)
{
    const auto world = room(hall(20, 60));
    FreeFlight flight(*world, lossless(0));
    world->spheres.add({0, 0, 0}, 1, 0);
    RunningSpheres& running = world->spheres.running();
    running.velocity[0] = {1.5, 4, -0.5};
    const int steps = static_cast<int>(std::lround(8 / dt));
    double worst = 0;
    for (int step = 1; step <= steps; ++step)
    {
        flight.advance(0, dt);
        const Eigen::Vector3d expected = oracle::thrown({1.5, 4, -0.5}, step * dt);
        worst = std::max(worst, (running.position[0] - expected).norm());
    }
    points.add("throw", "exact step", "step", dt, worst, 1e-12 * steps + 1e-12);
}

void measureBounce(ClosedFormPoints& points, double dt)
{
    constexpr double kDrop = 10;
    constexpr double kRestitution = 0.7;
    const double expected = oracle::bounceApex(kDrop, kRestitution);
    const auto world = room(hall(5, 60));
    FreeFlight flight(*world, lossless(kRestitution));
    world->spheres.add({0.3, -29 + kDrop, 0.2}, 1, 0);
    RunningSpheres& running = world->spheres.running();
    const double ours = apexOf(
        [&]
        {
            flight.advance(0, dt);
            return std::pair(running.position[0].y() + 29, running.velocity[0].y());
        });
    points.add("bounce", "exact step", "step", dt, ours / expected - 1,
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
                return std::pair(hallOfPaper->spheres.position(0).y() + 29,
                                 hallOfPaper->spheres.velocity(0).y());
            });
        points.add("bounce", isExplicit ? "explicit Euler" : "semi-implicit Euler", "step", dt,
                   apex / expected - 1, kNoClaimOfMotion);
    }
}

void measureBounceToRest(ClosedFormPoints& points, double dt)
{
    constexpr double kDrop = 10;
    constexpr double kRestitution = 0.7;
    const double expected = oracle::bouncesEnd(kDrop, kRestitution);
    const auto world = room(hall(5, 60));
    FreeFlight flight(*world, lossless(kRestitution));
    world->spheres.add({0.3, -29 + kDrop, 0.2}, 1, 0);
    RunningSpheres& running = world->spheres.running();
    constexpr double kLow = 1e-6;
    double lastMotion = 0;
    for (double t = dt; t < 2 * expected; t += dt)
    {
        flight.advance(0, dt);
        if (running.position[0].y() + 29 > kLow)
        {
            lastMotion = t;
        }
    }
    // Bounces that take less than a step are not told apart, and those below the height at
    // which they are no longer looked at are left out.
    const double tail = oracle::bouncesBelow(kLow, kRestitution);
    points.add("bounce to rest", "exact step", "step", dt, lastMotion / expected - 1,
               (kStepsToRest * dt + tail) / expected);
}

void measureHeadOnPair(ClosedFormPoints& points, double dt)
{
    constexpr double kRestitution = 0.6;
    constexpr double kSpeed = 2;
    Scene scene = unitScene(Preset::fast);
    const auto world = room(hall(20, 60), scene);
    world->pull.uniform.setZero(); // weightless, so that the closed form holds
    FreeFlight flight(*world, lossless(kRestitution));
    Threads threads(1);
    RunningSpheres& pair = world->spheres.running();
    PositionSolver positionSolver(pair, flight, threads, {.restitution = {kRestitution, 0}});
    world->spheres.add({-3, 0, 0}, 1, 0);
    world->spheres.add({1, 0, 0}, 1, 0);
    pair.velocity[0] = {kSpeed, 0, 0};
    for (double t = 0; t < 4; t += dt)
    {
        flight.advance(0, dt);
        flight.advance(1, dt);
        positionSolver.resolve(dt);
    }
    const oracle::Speeds expected = oracle::collide(1, kSpeed, 1, 0, kRestitution);
    const double error = std::max(std::abs(pair.velocity[0].x() - expected.first),
                                  std::abs(pair.velocity[1].x() - expected.second));
    points.add("head-on pair", "exact step", "step", dt, error, 1e-9);
}

// Sliding down a slope, however finely it is cut. The room is tilted.
void measureIncline(ClosedFormPoints& points, int cuts)
{
    constexpr double kAngle = 0.35;
    constexpr double kTime = 8;
    const Eigen::Matrix3d tilt =
        Eigen::AngleAxisd(kAngle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const TriangleMesh mesh =
        moved(cutBoxMesh({-30, -6, -12}, {30, 6, 12}, cuts), 1, tilt, Eigen::Vector3d::Zero());
    const auto world = room(mesh);
    FreeFlight flight(*world, lossless(0));
    const Eigen::Vector3d start = tilt * Eigen::Vector3d(15, -5, 0.7);
    world->spheres.add(start, 1, 0);
    RunningSpheres& running = world->spheres.running();
    const int steps = 80;
    for (int step = 0; step < steps; ++step)
    {
        flight.advance(0, kTime / steps);
    }
    const Eigen::Vector3d expected =
        start - tilt * Eigen::Vector3d(oracle::slide(kAngle, kTime), 0, 0);
    points.add("incline", "exact step", "triangles", 2.0 * cuts * cuts,
               (running.position[0] - expected).norm(), 1e-9);
}

void measureBowl(ClosedFormPoints& points, int segments, double dt)
{
    constexpr double kBowl = 30;
    const TriangleMesh mesh = bowlMesh(segments, kBowl);
    const auto world = room(mesh);
    FreeFlight flight(*world, lossless(0));
    constexpr double kAmplitude = 0.35; // [rad] several triangles wide
    const double path = kBowl - 1.2;
    world->spheres.add({path * std::sin(kAmplitude), -path * std::cos(kAmplitude), 0.01}, 1, 0);
    RunningSpheres& running = world->spheres.running();
    std::vector<double> crossings;
    for (double t = 0; t < 100 && crossings.size() < 3; t += dt)
    {
        const double before = running.position[0].x();
        flight.advance(0, dt);
        const double now = running.position[0].x();
        if ((before > 0) != (now > 0))
        {
            crossings.push_back(t + dt * before / (before - now));
        }
    }
    // The ball loses amplitude at every crease, so only the first quarter and half swing are used.
    const double swing = oracle::bowlPeriod(kBowl, kAmplitude);
    const double half = crossings.size() > 1 ? crossings[1] - crossings[0] : 0;
    // On facets that turn by d the potential is linear between points of the parabola, from
    // which it differs by up to g (R - r) d^2 / 8: a share (d / 2A)^2 of the swing's energy.
    // How much of the amplitude the creases leave is not known either.
    const double turn = 2 * std::numbers::pi / segments;
    const double allowed = std::pow(turn / (2 * kAmplitude), 2) + kAmplitude * kAmplitude / 16;
    points.add("bowl", "exact step", "segments", segments, half / (swing / 2) - 1, allowed);
}

} // namespace frostfill
