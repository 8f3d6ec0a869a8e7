// SPDX-License-Identifier: MIT
#include "study/peers/peer_study.hpp"

#include "base/processor_time.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/quality/quality.hpp"
#include "study/peers/peer.hpp"
#include "study/peers/pouring.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <set>

namespace frostfill
{
namespace
{

constexpr const char* kOurName = "Frostfill";
constexpr const char* kLiggghtsName = "LIGGGHTS";

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

void markPeerFront(std::vector<PeerPoint>& points)
{
    for (PeerPoint& one : points)
    {
        one.onFront =
            std::none_of(points.begin(), points.end(),
                         [&](const PeerPoint& other)
                         {
                             return other.seconds <= one.seconds && other.worst() <= one.worst() &&
                                    (other.seconds < one.seconds || other.worst() < one.worst());
                         });
    }
}

using PeerRun = std::function<PeerPoint()>;

/// An engine of rigid bodies, which runs by steps of a given length.
struct RigidBodyPeer
{
    const char* name;
    bool (*has)();
    PeerResult (*run)(const PeerTask&, double step);
};
constexpr RigidBodyPeer kRigidBodyPeers[] = {
    {"Bullet", hasBullet, runBullet},
    {"ODE", hasOde, runOde},
};

void addSteps(std::vector<PeerRun>& runs, const PeerTask& task, const std::string& name,
              const std::function<PeerResult(const PeerTask&, double step)>& run)
{
    for (const double step : {0.12, 0.06})
    {
        runs.emplace_back(
            [&task, name, run, step]
            { return theirs(task, name, fmt::format("step {:g}", step), run(task, step)); });
    }
}

void addOthers(std::vector<PeerRun>& runs, const PeerTask& task,
               const std::vector<ProgramPeer>& programs)
{
    for (const RigidBodyPeer& peer : kRigidBodyPeers)
    {
        if (peer.has())
        {
            addSteps(runs, task, peer.name, peer.run);
        }
    }
    for (const ProgramPeer& peer : programs)
    {
        addSteps(runs, task, peer.name,
                 [peer](const PeerTask& all, double step)
                 { return runProgramPeer(peer, all, step); });
    }
    if (hasLiggghts())
    {
        for (const double stiffness : {4.5e3, 4.5e4})
        {
            runs.emplace_back(
                [&task, stiffness]
                {
                    return theirs(task, kLiggghtsName, fmt::format("stiffness {:g}", stiffness),
                                  runLiggghts(task, stiffness));
                });
        }
    }
}

} // namespace

std::vector<ProgramPeer> readProgramPeers(const std::vector<std::string>& texts)
{
    std::set<std::string> names = {kOurName, kLiggghtsName};
    for (const RigidBodyPeer& peer : kRigidBodyPeers)
    {
        names.insert(peer.name);
    }
    std::vector<ProgramPeer> programs;
    for (const std::string& text : texts)
    {
        programs.push_back(readProgramPeer(text));
        if (!names.insert(programs.back().name).second)
        {
            throw Error(ErrorCode::usage,
                        fmt::format("two engines have the name {}: give '{}' another one",
                                    programs.back().name, programs.back().program));
        }
    }
    return programs;
}

void requirePeers(const std::vector<ProgramPeer>& programs)
{
    std::for_each(programs.begin(), programs.end(), tryProgramPeer);
    const bool builtIn = std::any_of(std::begin(kRigidBodyPeers), std::end(kRigidBodyPeers),
                                     [](const RigidBodyPeer& peer) { return peer.has(); });
    if (programs.empty() && !builtIn && !hasLiggghts())
    {
        throw Error(ErrorCode::missingProgram,
                    "no other engine to compare with: name one by --peer, apt-get install "
                    "libbullet-dev or libode-dev and configure with -DFROSTFILL_PEERS=ON, or "
                    "apt-get install liggghts");
    }
}

std::vector<PeerPoint> measurePeers(bool quick, const std::vector<ProgramPeer>& programs,
                                    const StudyProgress& progress)
{
    const std::uint64_t count = quick ? 1000 : 10000;
    PeerTask task;
    task.mesh = cubeFilledTo(0.5, count);
    task.count = count;
    task.restitution = kPeerRestitution;
    task.secondsLimit = quick ? 15 : 60;
    std::vector<PeerRun> runs;
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        runs.emplace_back([&task, motion] { return ours(task, motion); });
    }
    addOthers(runs, task, programs);
    std::vector<PeerPoint> points;
    for (const PeerRun& run : runs)
    {
        points.push_back(run());
        progress(points.size(), runs.size(), points.back().engine + ", " + points.back().setting);
    }
    markPeerFront(points);
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
    table.headings = {"engine",  "setting", "seconds",     "simulated",    "at_rest",
                      "missing", "outside", "max_overlap", "mean_overlap", "wall_overlap",
                      "worst",   "ours",    "front"};
    for (const PeerPoint& p : points)
    {
        table.rows.push_back(
            {p.engine, p.setting, fmt::format("{:.4f}", p.seconds),
             fmt::format("{:.2f}", p.simulated), p.atRest ? "1" : "0", fmt::format("{}", p.missing),
             fmt::format("{}", p.outside), fmt::format("{:.4e}", p.maxOverlap),
             fmt::format("{:.4e}", p.meanOverlap), fmt::format("{:.4e}", p.wallOverlap),
             fmt::format("{:.4e}", p.worst()), p.ours ? "1" : "0", p.onFront ? "1" : "0"});
    }
    return table;
}

Table peersTable(const std::vector<PeerPoint>& points)
{
    Table table;
    table.title = "Other engines on the same cube, one thread each (* on the Pareto front)";
    table.words = 2;
    table.headings = {"engine",
                      "setting",
                      "seconds",
                      "at rest",
                      "missing or outside",
                      "largest overlap [r]",
                      "mean overlap [r]",
                      "in walls [r]",
                      "front"};
    for (const PeerPoint& p : points)
    {
        table.rows.push_back({p.engine, p.setting, fmt::format("{:.2f}", p.seconds),
                              p.atRest ? "yes" : "no", fmt::format("{}", p.missing + p.outside),
                              fmt::format("{:.1e}", p.maxOverlap),
                              fmt::format("{:.1e}", p.meanOverlap),
                              fmt::format("{:.1e}", p.wallOverlap), p.onFront ? "*" : ""});
    }
    return table;
}

} // namespace frostfill
