// SPDX-License-Identifier: MIT
#include "lab/pouring.hpp"
#include "lab/processor_time.hpp"
#include "lab/program_peer.hpp"
#include "lab/study.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/quality/quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace frostfill
{
namespace
{

/// Of the engines. [sqrt(r/g)]
constexpr double kPeerSteps[] = {0.12, 0.06};

/// In units of r.
Scene cubeScene(std::uint64_t count, Motion motion)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.radius = 1;
    scene.spheres.count = count;
    scene.motion.mode = motion;
    scene.motion.gravity = 1;
    scene.motion.restitution = kPeerRestitution;
    scene.threads = 1;
    return scene;
}

/// The common checker: overlaps and centres outside, for every engine alike.
void judge(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& places, PeerPoint& point)
{
    World world(cubeScene(places.size(), Motion::fall), mesh);
    for (const Eigen::Vector3d& place : places)
    {
        world.spheres.addResting(world.frame.toRun(place), 1, 0);
    }
    const QualityReport quality = examine(world);
    point.outside = quality.centresOutside + quality.notFinite;
    point.maxOverlap = quality.maxOverlap;
    point.meanOverlap = quality.meanOverlap;
    point.wallOverlap = quality.maxWallOverlap;
}

PeerPoint ours(const PeerTask& task, Motion motion)
{
    const ProcessorClock clock;
    World world(cubeScene(task.count, motion), task.mesh);
    const auto engine = makeEngine(world);
    while (engine->step())
    {
    }
    PeerPoint point;
    point.ours = true;
    point.engine = kOurName;
    point.setting = motion == Motion::fall ? "fall" : motion == Motion::skip ? "skip" : "descend";
    point.seconds = clock.seconds();
    point.simulated = world.clock.time;
    point.atRest = world.clock.finished;
    point.missing = task.count - world.spheres.size();
    std::vector<Eigen::Vector3d> places;
    for (std::uint32_t id = 0; id < world.spheres.size(); ++id)
    {
        places.push_back(world.frame.toMesh(world.spheres.position(id)));
    }
    judge(task.mesh, places, point);
    return point;
}

PeerPoint theirs(const PeerTask& task, const std::string& engine, const std::string& setting,
                 const PeerResult& result)
{
    PeerPoint point;
    point.engine = engine;
    point.setting = setting;
    point.seconds = result.seconds;
    point.simulated = result.simulated;
    point.atRest = result.atRest;
    point.missing = task.count - result.places.size();
    judge(task.mesh, result.places, point);
    return point;
}

} // namespace

std::vector<PeerPoint> measurePeers(bool quick, const std::vector<ProgramPeer>& engines,
                                    const LabProgress& progress)
{
    const std::uint64_t count = quick ? 1000 : 10000;
    PeerTask task;
    task.mesh = cubeFilledTo(0.5, count);
    task.count = count;
    task.restitution = kPeerRestitution;
    task.secondsLimit = quick ? 15 : 60;
    std::vector<std::function<PeerPoint()>> runs;
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        runs.emplace_back([&task, motion] { return ours(task, motion); });
    }
    for (const ProgramPeer& engine : engines)
    {
        for (const double step : kPeerSteps)
        {
            runs.emplace_back(
                [&task, engine, step]
                {
                    return theirs(task, engine.name, fmt::format("step {:g}", step),
                                  runProgramPeer(engine, task, step));
                });
        }
    }
    std::vector<PeerPoint> points;
    for (const auto& run : runs)
    {
        points.push_back(run());
        progress(points.size(), runs.size(), points.back().engine + ", " + points.back().setting);
    }
    return points;
}

double peerRatio(const std::vector<PeerPoint>& points, const std::string& motion)
{
    double own = std::numeric_limits<double>::infinity();
    double other = own;
    for (const PeerPoint& point : points)
    {
        if (!point.ours)
        {
            other = std::min(other, point.seconds);
        }
        else if (point.setting == motion)
        {
            own = point.seconds;
        }
    }
    return other / own;
}

Table peersCsv(const std::vector<PeerPoint>& points)
{
    Table table;
    table.headings = {"engine",       "setting",      "seconds", "simulated",
                      "at_rest",      "missing",      "outside", "max_overlap",
                      "mean_overlap", "wall_overlap", "worst",   "ours"};
    for (const PeerPoint& p : points)
    {
        table.rows.push_back(
            {p.engine, p.setting, fmt::format("{:.4f}", p.seconds),
             fmt::format("{:.2f}", p.simulated), p.atRest ? "1" : "0", fmt::format("{}", p.missing),
             fmt::format("{}", p.outside), fmt::format("{:.4e}", p.maxOverlap),
             fmt::format("{:.4e}", p.meanOverlap), fmt::format("{:.4e}", p.wallOverlap),
             fmt::format("{:.4e}", p.worst()), p.ours ? "1" : "0"});
    }
    return table;
}

} // namespace frostfill
