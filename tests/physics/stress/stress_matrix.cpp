// SPDX-License-Identifier: MIT
#include "physics/stress/stress_matrix.hpp"

#include "base/random.hpp"
#include "lab/meshes.hpp"
#include "physics/stress/stress_meshes.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

constexpr double kRadius = 0.1;
constexpr std::uint64_t kSpheres = 40;
constexpr double kGravity = 9.81;
/// More spheres at once than this would take the paper's method, which tests all against all,
/// hours.
constexpr std::size_t kMaxAllPairs = 1000;
/// More than this would settle together for an hour, and more grains would move for as long.
constexpr std::size_t kMaxTogether = 10000;
constexpr std::size_t kMaxGrains = 1000;

/// The scene that every cell varies: 40 spheres in groups of 10, two groups a set.
Scene sceneFor(const StressMethod& method)
{
    Scene scene = presetScene(method.preset, "torus");
    scene.name = "stress";
    scene.motion.integrator = method.integrator;
    scene.motion.mode = method.motion;
    scene.rest.mode = method.rest;
    scene.rest.friction = method.friction;
    scene.rest.rollingFriction = method.rollingFriction;
    scene.spheres.radius = kRadius;
    scene.spheres.count = kSpheres;
    scene.spheres.groupSize = 10;
    scene.spheres.groupsPerSet = 2;
    return scene;
}

StressRun runIn(const StressMethod& method, TriangleMesh mesh)
{
    StressRun run;
    run.scene = sceneFor(method);
    run.mustBeClean = method.preset == Preset::fast; // the paper's leaves overlaps by its nature
    run.mesh = std::move(mesh);
    return run;
}

StressRun runInTorus(const StressMethod& method)
{
    return runIn(method, builtInMesh("torus"));
}

class Matrix
{
public:
    /// A cell whose scene is the usual one but for a change.
    void add(const std::string& axis, const std::string& label, Expectation expected,
             const std::function<void(StressRun&)>& change)
    {
        cells_.push_back({axis, label, expected,
                          [change](const StressMethod& method)
                          {
                              StressRun run = runInTorus(method);
                              change(run);
                              return run;
                          },
                          kSpheres});
    }
    void add(const std::string& axis, const std::string& label,
             const std::function<void(StressRun&)>& change)
    {
        add(axis, label, Expectation::passes, change);
    }
    [[nodiscard]] StressCell& last() { return cells_.back(); }
    std::vector<StressCell> take() { return std::move(cells_); }

private:
    std::vector<StressCell> cells_;
};

void addSteps(Matrix& matrix, bool quick)
{
    for (const double dt : {1e-4, 1e-3, 1e-2, 3e-2, 1e-1})
    {
        if (dt > 1e-4 || !quick)
        {
            matrix.add("step [s]", fmt::format("{:g}", dt),
                       [dt](StressRun& run) { run.scene.motion.dt = dt; });
        }
    }
    for (const double dt : {1e-3, 1e-2, 3e-2, 1e-1})
    {
        matrix.add("step [s] at e = 1", fmt::format("{:g}", dt),
                   [dt](StressRun& run)
                   {
                       run.scene.motion.dt = dt;
                       run.scene.motion.restitution = 1;
                       run.mustRest = false;
                   });
    }
    for (const double e : {0.0, 0.2, 0.5, 0.8, 0.95, 1.0})
    {
        matrix.add("restitution", fmt::format("{:g}", e),
                   [e](StressRun& run)
                   {
                       run.scene.motion.restitution = e;
                       run.mustRest = e < 1;
                   });
    }
}

// Centres of so many spheres in the cube from -1 to 1, on a grid that is shaken a little, so that
// none touch.
std::vector<PlacedSphere> shakenGrid(std::size_t count, double radius)
{
    constexpr double kShake = 0.9; // of the gap between neighbours
    const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count))));
    const double pitch = 2.0 / static_cast<double>(side);
    const auto along = [=](std::size_t at, std::size_t id, std::uint64_t axis)
    {
        const double shake = kShake * (pitch - 2 * radius) * (uniformRandom(1, id, axis) - 0.5);
        return -1 + pitch * (static_cast<double>(at) + 0.5) + shake;
    };
    std::vector<PlacedSphere> spheres;
    for (std::size_t k = 0; k < count; ++k)
    {
        const double x = along(k / side % side, k, 0);
        const double y = along(k / (side * side), k, 1);
        spheres.push_back({{x, y, along(k % side, k, 2)}, radius});
    }
    return spheres;
}

// Spheres that take a fifth of the cube's volume and all run from the start.
void addCrowds(Matrix& matrix, bool quick)
{
    constexpr double kShare = 0.2;
    for (const std::uint32_t count : {10u, 100u, 1000u, 10000u, 100000u})
    {
        if (quick && count > 1000)
        {
            continue;
        }
        const double volume = 8 * kShare / count;
        const double radius = std::cbrt(volume / (4.0 / 3.0 * std::numbers::pi));
        matrix.add("running at once", fmt::format("{}", count),
                   [=](StressRun& run)
                   {
                       run.mesh = builtInMesh("cube");
                       run.placed = shakenGrid(count, radius);
                       run.scene.spheres.radius = radius;
                       run.scene.spheres.count = count;
                       run.secondsLimit = 400;
                   });
        matrix.last().atOnce = count;
        matrix.last().entangled = count == 10; // its spheres are wider than its grid
    }
    for (const std::uint32_t size : {1u, 5u, 20u, 40u})
    {
        matrix.add("spheres in a group", fmt::format("{}", size),
                   [size](StressRun& run)
                   {
                       run.scene.spheres.groupSize = size;
                       run.scene.spheres.groupsPerSet = 1;
                   });
    }
    for (const double ratio : {1.0, 2.0, 5.0, 10.0, 20.0})
    {
        matrix.add("size ratio", fmt::format("1:{:g}", ratio),
                   [ratio](StressRun& run)
                   {
                       // The cost of looking for places grows with the volume over the smallest's.
                       run.mesh = cutBoxMesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
                       run.scene.spheres.radius = Radii(0.2 / ratio, 0.2);
                   });
    }
}

void addUnits(Matrix& matrix)
{
    const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
    for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    {
        matrix.add("scale", fmt::format("{:g}", scale),
                   [=](StressRun& run)
                   {
                       run.mesh = moved(run.mesh, scale, same, Eigen::Vector3d::Zero());
                       run.scene.spheres.radius = scale * kRadius;
                   });
    }
    for (const double offset : {0.0, 1e2, 1e4, 1e6})
    {
        matrix.add("offset", fmt::format("{:g}", offset),
                   [=](StressRun& run)
                   { run.mesh = moved(run.mesh, 1, same, offset * Eigen::Vector3d(1, -1, 0.5)); });
    }
    for (const double factor : {0.0, 1e-3, 1.0, 1e3})
    {
        matrix.add("gravity", fmt::format("x{:g}", factor),
                   factor > 0 ? Expectation::passes : Expectation::refuses,
                   [factor](StressRun& run) { run.scene.motion.gravity = factor * kGravity; });
    }
    for (const auto& [axis, name] : {std::pair(Axis::x, "x up"), std::pair(Axis::z, "z up")})
    {
        matrix.add("direction", name,
                   [axis = axis](StressRun& run) { run.scene.object.up = axis; });
    }
    for (const double degrees : {30.0, 45.0, 90.0, 180.0})
    {
        matrix.add("direction", fmt::format("{:g} deg", degrees),
                   [=](StressRun& run)
                   {
                       const Eigen::Vector3d axis = Eigen::Vector3d(1, 0.2, 0.7).normalized();
                       const double angle = degrees * std::numbers::pi / 180;
                       run.mesh =
                           moved(run.mesh, 1, Eigen::AngleAxisd(angle, axis).toRotationMatrix(),
                                 Eigen::Vector3d::Zero());
                   });
    }
}

void addMeshes(Matrix& matrix)
{
    for (const int exponent : {-3, -7, -12, -16})
    {
        matrix.add("mesh", fmt::format("sliver 1e{}", exponent),
                   [=](StressRun& run)
                   { run.mesh = withSlivers(run.mesh, std::pow(10, exponent)); });
    }
    matrix.add("mesh", "duplicates",
               [](StressRun& run) { run.mesh = withDuplicates(run.mesh, 200); });
    matrix.add("mesh", "T-junctions", Expectation::either,
               [](StressRun& run) { run.mesh = withTJunctions(run.mesh, 7); });
    matrix.add("mesh", "needles", [](StressRun& run) { run.mesh = needleCylinder(2000); });
    matrix.add("mesh", "inside out", [](StressRun& run) { run.mesh = insideOut(run.mesh); });
}

std::vector<PlacedSphere> crowd(std::size_t count, double radius, double halfWidth)
{
    std::vector<PlacedSphere> spheres;
    for (std::size_t k = 0; k < count; ++k)
    {
        // Kronecker's sequence: even, but nothing like a lattice.
        Eigen::Vector3d p;
        for (int axis = 0; axis < 3; ++axis)
        {
            const double step = std::pow(0.8191725134, axis + 1);
            p[axis] = halfWidth * (2 * std::fmod(0.5 + step * static_cast<double>(k), 1.0) - 1);
        }
        spheres.push_back({p, radius});
    }
    return spheres;
}

void addReleases(Matrix& matrix)
{
    const auto release = [&](const char* label, Expectation expected,
                             const std::vector<PlacedSphere>& spheres, int cuts = 8)
    {
        matrix.add("released", label, expected,
                   [=](StressRun& run)
                   {
                       run.mesh = cutBoxMesh({-1, -1, -1}, {1, 1, 1}, cuts);
                       run.placed = spheres;
                       run.scene.spheres.radius = spheres.front().radius;
                       run.scene.spheres.count = spheres.size();
                   });
        matrix.last().atOnce = spheres.size();
    };
    const double r = kRadius;
    const auto entangle = [&](const char* label, const std::vector<PlacedSphere>& spheres)
    {
        release(label, Expectation::passes, spheres);
        matrix.last().entangled = true;
    };
    entangle("overlap 40", crowd(40, r, 0.3));
    entangle("overlap 300", crowd(300, 0.136, 0.86));
    entangle("same place 2", {{{0, 0.1, 0}, r}, {{0, 0.1, 0}, r}});
    entangle("same place 7", std::vector<PlacedSphere>(7, {{0.03, 0.1, 0.02}, r}));
    release("over edge", Expectation::passes, {{{0.1, 0.4, 0}, r}, {{0.5, -0.6, 0.3}, r}});
    release("over vertex", Expectation::passes, {{{0.25, 0.4, 0.5}, r}, {{0, -0.6, 0}, r}});
    release("on sphere", Expectation::passes,
            {{{0, -0.9, 0}, r}, {{0, -0.6, 0}, r}, {{0, -0.3, 0}, r}, {{0, 0, 0}, r}});
    release("in wall", Expectation::either, {{{0.95, 0.2, 0.1}, r}, {{0, 0.97, -0.99}, r}});
    release("on edge", Expectation::refuses, {{{-1, -1, 0.1}, r}});
    release("on vertex", Expectation::refuses, {{{-1, -1, -1}, r}});
    release("outside", Expectation::refuses, {{{0, 1.3, 0}, r}});
}

void addFits(Matrix& matrix)
{
    const auto fit = [&](const char* label, Expectation expected, const TriangleMesh& mesh,
                         double radius, std::uint64_t count)
    {
        matrix.add("radius", label, expected,
                   [=](StressRun& run)
                   {
                       run.mesh = mesh;
                       run.scene.spheres.radius = radius;
                       run.scene.spheres.count = count;
                   });
    };
    const TriangleMesh slot = cutBoxMesh({-kRadius, -1, -1}, {kRadius, 1, 1});
    const TriangleMesh cube = builtInMesh("cube");
    fit("= half gap", Expectation::either, slot, kRadius, 20);
    fit("gap - 1e-9", Expectation::either, slot, kRadius * (1 - 1e-9), 20);
    fit("gap - 1e-3", Expectation::passes, slot, kRadius * (1 - 1e-3), 20);
    fit("fills cube", Expectation::either, cube, 1, 1);
    fit("99 %", Expectation::passes, cube, 0.99, 1);
    fit("too large", Expectation::refuses, cube, 1.2, 1);
    fit("x 1000", Expectation::refuses, cube, 1000, 1);
}

} // namespace

const std::vector<StressMethod>& stressMethods()
{
    static const std::vector<StressMethod> kMethods = {
        {"fast", Preset::fast, Integrator::explicitEuler, Motion::fall},
        {"fast skip", Preset::fast, Integrator::explicitEuler, Motion::skip},
        {"joint", Preset::fast, Integrator::explicitEuler, Motion::skip, Rest::joint, 0.3},
        {"grains", Preset::fast, Integrator::explicitEuler, Motion::granular, Rest::joint, 0.6,
         0.1},
        {"paper", Preset::paper, Integrator::explicitEuler, Motion::fall},
        {"paper semi-implicit", Preset::paper, Integrator::semiImplicitEuler, Motion::fall},
    };
    return kMethods;
}

bool isSound(const StressOutcome& outcome, Expectation expected)
{
    const Verdict verdict = outcome.verdict;
    if (outcome.unsettled && (verdict == Verdict::restless || verdict == Verdict::overlaps))
    {
        return expected == Expectation::either; // it says so
    }
    return verdict == Verdict::passes    ? expected != Expectation::refuses
           : verdict == Verdict::refused ? expected != Expectation::passes
                                         : false;
}

bool takesTooLong(const StressCell& cell, const StressMethod& method)
{
    const std::size_t most = method.preset == Preset::paper      ? kMaxAllPairs
                             : method.rest != Rest::joint        ? cell.atOnce
                             : method.motion == Motion::granular ? kMaxGrains
                                                                 : kMaxTogether;
    return cell.atOnce > most;
}

std::vector<StressCell> stressMatrix(bool quick)
{
    Matrix matrix;
    addSteps(matrix, quick);
    addCrowds(matrix, quick);
    addUnits(matrix);
    addMeshes(matrix);
    addReleases(matrix);
    addFits(matrix);
    return matrix.take();
}

} // namespace frostfill
