// SPDX-License-Identifier: MIT
#include "lab/triangle_growth.hpp"

#include "lab/processor_time.hpp"
#include "run/frame_painter.hpp"

#include <frostfill/renderer.hpp>
#include <frostfill/simulation.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

namespace frostfill
{
namespace
{

constexpr std::size_t kGrowthSpheres = 500;
constexpr std::size_t kFewGrowthSpheres = 100;
/// Consecutive steps in the middle of the run. The first pictures bring up what is kept.
constexpr int kFirstPictures = 2;
constexpr int kGrowthPictures = 16;
constexpr std::size_t kReachMemory = std::size_t{8} << 20; ///< as `fill` has for it [bytes]
/// Below, what does not depend on the triangles is most of the cost.
constexpr std::size_t kManyTriangles = 10000;

/// That this program and its children have used, other than the clock of this program alone: a
/// mesh is read in a child.
double secondsOfAll()
{
    return ProcessorClock::now() + processorSecondsOfChildren();
}

template <class Work>
double secondsOf(Work&& work)
{
    const double before = secondsOfAll();
    work();
    return secondsOfAll() - before;
}

double secondsToLoad(const TriangleMesh& mesh)
{
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / fmt::format("frostfill_growth_{}.ply", getpid());
    savePly(mesh, file);
    const double seconds = secondsOf([&] { static_cast<void>(loadMesh(file)); });
    std::filesystem::remove(file);
    return seconds;
}

/// Of one picture.
double secondsToDraw(Renderer& renderer, Simulation& simulation)
{
    Snapshot snapshot;
    double seconds = 0;
    for (int k = 0; k < kFirstPictures + kGrowthPictures; ++k)
    {
        simulation.capture(snapshot);
        const double its = secondsOf([&] { static_cast<void>(renderer.draw(snapshot)); });
        seconds += k < kFirstPictures ? 0 : its;
        simulation.step();
    }
    return seconds / kGrowthPictures;
}

TriangleGrowthPoint measure(const TriangleMesh& mesh, std::size_t spheres)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.motion.mode = Motion::skip;
    scene.spheres.radius.reset();
    scene.spheres.count = spheres;
    scene.threads = 1;
    TriangleGrowthPoint point;
    point.triangles = mesh.triangles.size();
    point.load = secondsToLoad(mesh);
    std::optional<Simulation> simulation;
    point.prepare = secondsOf(
        [&]
        {
            simulation.emplace(scene, mesh);
            static_cast<void>(simulation->inspectReach(kReachMemory));
        });
    const double first = secondsOf(
        [&]
        {
            while (simulation->sphereCount() < spheres / 2 && simulation->step())
            {
            }
        });
    Renderer renderer(mesh, renderSettings(scene));
    const std::size_t before = simulation->sphereCount();
    point.picture = secondsToDraw(renderer, *simulation);
    const std::size_t after = simulation->sphereCount();
    const double second = secondsOf(
        [&]
        {
            while (simulation->step())
            {
            }
        });
    point.sphere =
        (first + second) / static_cast<double>(simulation->sphereCount() - (after - before));
    return point;
}

} // namespace

TriangleMesh bumpyTorus(std::size_t triangles)
{
    // Three times as many sides around the ring as around the tube make them about equal.
    const auto sides = std::max(
        3U, static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 6))));
    const std::uint32_t segments = 3 * sides;
    TriangleMesh mesh;
    mesh.vertices.reserve(std::size_t{segments} * sides);
    mesh.triangles.reserve(2 * std::size_t{segments} * sides);
    const auto vertex = [&](std::uint32_t i, std::uint32_t j)
    { return i % segments * sides + j % sides; };
    for (std::uint32_t i = 0; i < segments; ++i)
    {
        const double u = 2 * std::numbers::pi * i / segments;
        for (std::uint32_t j = 0; j < sides; ++j)
        {
            const double v = 2 * std::numbers::pi * j / sides;
            const double tube = 0.4 + 0.02 * std::sin(17 * u) * std::sin(11 * v);
            const double ring = 1 + tube * std::cos(v);
            mesh.vertices.emplace_back(ring * std::cos(u), ring * std::sin(u), tube * std::sin(v));
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    return mesh;
}

std::vector<TriangleGrowthPoint> measureTriangleGrowth(
    bool quick, const std::function<void(std::size_t, std::size_t, const std::string&)>& progress)
{
    std::vector<std::size_t> counts = {1000, 3000, 10000};
    if (!quick)
    {
        counts.insert(counts.end(), {30000, 100000, 300000, 1000000, 4000000});
    }
    std::vector<TriangleGrowthPoint> points;
    for (const std::size_t count : counts)
    {
        progress(points.size(), counts.size(), fmt::format("{} triangles", count));
        points.push_back(measure(bumpyTorus(count), quick ? kFewGrowthSpheres : kGrowthSpheres));
    }
    return points;
}

double growthPower(const std::vector<TriangleGrowthPoint>& points,
                   double TriangleGrowthPoint::*cost, std::size_t from)
{
    double n = 0;
    double x = 0;
    double y = 0;
    double xx = 0;
    double xy = 0;
    for (const TriangleGrowthPoint& point : points)
    {
        if (point.triangles >= from && point.*cost > 0)
        {
            const double atX = std::log(static_cast<double>(point.triangles));
            const double atY = std::log(point.*cost);
            n += 1;
            x += atX;
            y += atY;
            xx += atX * atX;
            xy += atX * atY;
        }
    }
    return n < 2 ? 0 : (n * xy - x * y) / (n * xx - x * x);
}

std::vector<TriangleGrowth> triangleGrowth(const std::vector<TriangleGrowthPoint>& points)
{
    const auto many = std::count_if(points.begin(), points.end(),
                                    [](const TriangleGrowthPoint& point)
                                    { return point.triangles >= kManyTriangles; });
    const std::size_t from = many < 2 ? 0 : kManyTriangles;
    return {{"loading", growthPower(points, &TriangleGrowthPoint::load, from)},
            {"preparing", growthPower(points, &TriangleGrowthPoint::prepare, from)},
            {"a sphere", growthPower(points, &TriangleGrowthPoint::sphere, from)},
            {"a picture", growthPower(points, &TriangleGrowthPoint::picture, from)}};
}

Table triangleGrowthCsv(const std::vector<TriangleGrowthPoint>& points)
{
    Table table;
    table.headings = {"triangles", "load", "prepare", "sphere", "picture"};
    table.words = 0;
    for (const TriangleGrowthPoint& point : points)
    {
        table.rows.push_back({fmt::format("{}", point.triangles), fmt::format("{:.6g}", point.load),
                              fmt::format("{:.6g}", point.prepare),
                              fmt::format("{:.6g}", point.sphere),
                              fmt::format("{:.6g}", point.picture)});
    }
    return table;
}

} // namespace frostfill
