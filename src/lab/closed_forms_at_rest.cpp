// SPDX-License-Identifier: MIT
#include "lab/closed_form_parts.hpp"
#include "lab/meshes.hpp"
#include "oracle/rest.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/motion/drop_and_roll.hpp"

#include <cmath>
#include <limits>

/// Where spheres come to rest, against closed forms.
namespace frostfill
{
namespace
{

constexpr double kNotFrozen = 1e-9; // from its place, of a sphere at rest that still runs [r]
// The paper's method rests as well as its step lets it; nothing is promised.
constexpr double kNoClaimAtRest = std::numeric_limits<double>::infinity();

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
double runningError(const TriangleMesh& mesh, const Eigen::Vector3d& start,
                    const Eigen::Vector3d& expected)
{
    const auto world = room(mesh);
    FreeFlight::Settings settings;
    settings.restitution.coefficient = 0;
    FreeFlight flight(*world, settings);
    world->spheres.add(start, 1, 0);
    RunningSpheres& running = world->spheres.running();
    for (int step = 0; step < 2000; ++step)
    {
        flight.advance(0, 0.1);
    }
    return (running.position[0] - expected).head<2>().norm();
}

void addFast(ClosedFormPoints& points, const char* problem, const char* parameter, double value,
             const TriangleMesh& mesh, const Eigen::Vector3d& start,
             const Eigen::Vector3d& expected)
{
    points.add(problem, "fast", parameter, value, restingError(Preset::fast, mesh, start, expected),
               1e-7);
    points.add(problem, "fast, not frozen", parameter, value, runningError(mesh, start, expected),
               kNotFrozen);
}

} // namespace

// The mesh of a cone is a pyramid that touches it from outside.
void measureCones(ClosedFormPoints& points)
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
        const Eigen::Vector3d expected(0, -kHeight / 2 + oracle::aboveTip(angle), 0);
        const Eigen::Vector3d start(0.1, 2.4, 0.1);
        const double degrees = angle * 180 / std::numbers::pi;
        addFast(points, "cone", "half angle", degrees, mesh, start, expected);
    }
}

void measureGrooves(ClosedFormPoints& points)
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
        const Eigen::Vector3d expected(0, -height / 2 + oracle::aboveTip(angle), 0);
        const Eigen::Vector3d start(0.2, 2.4, 0.4);
        const double degrees = angle * 180 / std::numbers::pi;
        addFast(points, "groove", "half angle", degrees, mesh, start, expected);
        points.add("groove", "paper", "half angle", degrees,
                   restingError(Preset::paper, mesh, start, expected), kNoClaimAtRest);
    }
}

// In a cube of half edge 5 that stands on a corner.
void measureCorner(ClosedFormPoints& points)
{
    const Eigen::Matrix3d stand =
        Eigen::AngleAxisd(std::acos(1 / std::sqrt(3.0)), Eigen::Vector3d(-1, 0, 1).normalized())
            .toRotationMatrix();
    const TriangleMesh mesh =
        moved(cutBoxMesh({-5, -5, -5}, {5, 5, 5}, 3), 1, stand, Eigen::Vector3d::Zero());
    const Eigen::Vector3d expected(0, -5 * std::sqrt(3.0) + oracle::aboveCorner(), 0);
    const Eigen::Vector3d start(0.3, -2, 0.2);
    addFast(points, "corner", "cuts", 3, mesh, start, expected);
    points.add("corner", "paper", "cuts", 3, restingError(Preset::paper, mesh, start, expected),
               kNoClaimAtRest);
}

void measureThreeSpheres(ClosedFormPoints& points)
{
    const auto world = room(cutBoxMesh({-8, -8, -8}, {8, 8, 8}));
    for (const Eigen::Vector3d& p : oracle::threeTouching(-7))
    {
        world->spheres.addResting(p, 1, 0);
    }
    DropAndRoll descent(*world);
    Eigen::Vector3d place(0.2, 0, 0.1);
    (void)descent.settle(place, 1);
    const Eigen::Vector3d expected(0, -7 + oracle::aboveThree(), 0);
    points.add("on three spheres", "fast", "spheres", 3, (place - expected).norm(), 1e-7);
}

} // namespace frostfill
