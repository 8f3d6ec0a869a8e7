// SPDX-License-Identifier: MIT
#include "lab/pouring.hpp"
#include "lab/processor_time.hpp"
#include "lab/study.hpp"
#include "simulation/quality/quality.hpp"

#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr double kShareOfCube = 0.4; // of the cube: above a pile, others need room to pour
constexpr double kEngineLimit = 300; // of processor time [s]
constexpr double kEngineStep = 0.06; // [sqrt(r/g)]

struct RestMethod
{
    const char* curve;
    const char* setting;
    Rest rest;
    Motion motion;
    bool needsFriction;
};
constexpr RestMethod kRestMethods[] = {
    {"each", "fall", Rest::each, Motion::fall, false},
    {"each", "skip", Rest::each, Motion::skip, false},
    {"each", "descend", Rest::each, Motion::descend, false},
    {"joint", "fall", Rest::joint, Motion::fall, false},
    {"joint", "skip", Rest::joint, Motion::skip, false},
    {"joint", "descend", Rest::joint, Motion::descend, false},
    {"joint", "granular", Rest::joint, Motion::granular, true},
};

/// Judges centres alone, of any engine: the number of spheres that would move if all were let go.
RestPoint judged(const PeerTask& task, const std::vector<Eigen::Vector3d>& places)
{
    const std::vector<double> radii(places.size(), 1);
    const std::vector<bool> atRest(places.size(), true);
    const QualityReport quality =
        examine(task.mesh, places, radii, atRest, Axis::y, {.friction = task.friction});
    const EquilibriumReport& balance = quality.equilibrium.value();
    RestPoint point;
    point.friction = task.friction;
    point.spheres = balance.spheres;
    point.unbalanced = static_cast<double>(balance.unbalanced) /
                       std::max(1.0, static_cast<double>(balance.spheres));
    point.leastFriction = balance.leastFriction;
    point.largestUnbalance = balance.largest;
    point.maxOverlap = std::max(quality.maxOverlap, quality.maxWallOverlap);
    return point;
}

RestPoint ourRest(const PeerTask& task, const RestMethod& method)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.radius = 1;
    scene.spheres.count = task.count;
    scene.motion.mode = method.motion;
    scene.motion.restitution = task.restitution;
    scene.rest.mode = method.rest;
    scene.rest.friction = method.rest == Rest::joint ? task.friction : 0;
    scene.threads = 1;
    const ProcessorClock clock;
    Simulation simulation(scene, task.mesh);
    while (simulation.step())
    {
    }
    const double seconds = clock.seconds();
    std::vector<Eigen::Vector3d> places;
    for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
    {
        places.push_back(simulation.sphere(id).centre);
    }
    RestPoint point = judged(task, places);
    point.curve = method.curve;
    point.setting = method.setting;
    point.isDefault = method.rest == Rest::each && method.motion == Motion::fall;
    point.seconds = seconds;
    const auto settling = simulation.quality().settling;
    point.rests = !settling || settling->settled;
    return point;
}

RestPoint restOfEngine(const PeerTask& task, const ProgramPeer& engine)
{
    const PeerResult result = runProgramPeer(engine, task, kEngineStep);
    RestPoint point = judged(task, result.places);
    point.curve = engine.name;
    point.setting = fmt::format("step {:g}", kEngineStep);
    point.seconds = result.seconds;
    point.rests = result.atRest;
    return point;
}

} // namespace

std::vector<RestPoint> measureRest(bool quick, const std::vector<ProgramPeer>& engines,
                                   const LabProgress& progress)
{
    PeerTask task;
    task.count = quick ? 300 : 1000;
    task.mesh = cubeFilledTo(kShareOfCube, task.count);
    task.restitution = kPeerRestitution;
    task.secondsLimit = kEngineLimit;
    std::vector<RestPoint> points;
    const std::size_t all = 2 * (std::size(kRestMethods) + engines.size()) - 1;
    const auto add = [&](const RestPoint& point)
    {
        points.push_back(point);
        progress(points.size(), all, point.curve + ", " + point.setting);
    };
    for (const double friction : {0.0, 0.3})
    {
        task.friction = friction;
        for (const RestMethod& method : kRestMethods)
        {
            if (friction > 0 || !method.needsFriction)
            {
                add(ourRest(task, method));
            }
        }
        for (const ProgramPeer& engine : engines)
        {
            add(restOfEngine(task, engine));
        }
    }
    return points;
}

Table restCsv(const std::vector<RestPoint>& points)
{
    Table table;
    table.headings = {"curve",   "setting",  "rivals",         "seconds",           "error",
                      "default", "friction", "least_friction", "largest_unbalance", "max_overlap",
                      "spheres", "rests"};
    for (const RestPoint& p : points)
    {
        table.rows.push_back({p.curve, p.setting, fmt::format("friction {:g}", p.friction),
                              fmt::format("{:.4f}", p.seconds), fmt::format("{:.4e}", p.unbalanced),
                              p.isDefault ? "1" : "0", fmt::format("{:.6g}", p.friction),
                              fmt::format("{:.6g}", p.leastFriction),
                              fmt::format("{:.6g}", p.largestUnbalance),
                              fmt::format("{:.6g}", p.maxOverlap), fmt::format("{}", p.spheres),
                              p.rests ? "1" : "0"});
    }
    return table;
}

} // namespace frostfill
