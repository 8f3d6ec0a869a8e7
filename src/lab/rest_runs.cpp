// SPDX-License-Identifier: MIT
#include "lab/finish_run.hpp"
#include "lab/pouring.hpp"
#include "lab/study.hpp"
#include "simulation/quality/quality.hpp"

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

/// Judges places alone, whoever has found them: how many would move if nobody held anything.
ErrorPoint judged(const PeerTask& task, const std::vector<Eigen::Vector3d>& places)
{
    const std::vector<double> radii(places.size(), 1);
    const std::vector<bool> atRest(places.size(), true);
    const QualityReport quality =
        examine(task.mesh, places, radii, atRest, Axis::y, {.friction = task.friction});
    const EquilibriumReport& balance = quality.equilibrium.value();
    const auto spheres = static_cast<double>(balance.spheres);
    ErrorPoint point;
    point.rivals = fmt::format("friction {:g}", task.friction);
    point.error = static_cast<double>(balance.unbalanced) / std::max(1.0, spheres);
    point.details = {task.friction, balance.leastFriction, balance.largest,
                     std::max(quality.maxOverlap, quality.maxWallOverlap), spheres};
    return point;
}

ErrorPoint ourRest(const PeerTask& task, const RestMethod& method)
{
    Scene scene = studyScene(Preset::fast, "cube", 1);
    scene.spheres.count = task.count;
    scene.motion.mode = method.motion;
    scene.motion.restitution = task.restitution;
    scene.rest.mode = method.rest;
    scene.rest.friction = method.rest == Rest::joint ? task.friction : 0;
    const Finished run = finishRun(scene, task.mesh);
    std::vector<Eigen::Vector3d> places;
    for (std::uint32_t id = 0; id < run.world->spheres.size(); ++id)
    {
        places.push_back(run.world->frame.toMesh(run.world->spheres.position(id)));
    }
    ErrorPoint point = judged(task, places);
    point.curve = method.curve;
    point.setting = method.setting;
    point.isDefault = method.rest == Rest::each && method.motion == Motion::fall;
    point.seconds = run.seconds;
    const auto& settling = run.quality.settling;
    point.details.push_back(settling && !settling->settled ? 0 : 1);
    return point;
}

ErrorPoint restOfEngine(const PeerTask& task, const ProgramPeer& engine, double step)
{
    const PeerResult result = runProgramPeer(engine, task, step);
    ErrorPoint point = judged(task, result.places);
    point.curve = engine.name;
    point.setting = fmt::format("step {:g}", step);
    point.seconds = result.seconds;
    point.details.push_back(result.atRest ? 1 : 0);
    return point;
}

} // namespace

ErrorStudy measureRest(bool quick, const std::vector<ProgramPeer>& engines,
                       const LabProgress& progress)
{
    ErrorStudy study{
        "rest",
        "share of spheres unbalanced by more than a tenth of their weight",
        {"friction", "least_friction", "largest_unbalance", "max_overlap", "spheres", "rests"},
        {}};
    PeerTask task;
    task.count = quick ? 300 : 1000;
    task.mesh = cubeFilledTo(kShareOfCube, task.count);
    task.restitution = kPeerRestitution;
    task.secondsLimit = kEngineLimit;
    std::vector<std::function<ErrorPoint()>> runs;
    for (const double friction : {0.0, 0.3})
    {
        task.friction = friction;
        for (const RestMethod& method : kRestMethods)
        {
            if (friction > 0 || !method.needsFriction)
            {
                runs.emplace_back([=] { return ourRest(task, method); });
            }
        }
        for (const ProgramPeer& engine : engines)
        {
            runs.emplace_back([=] { return restOfEngine(task, engine, kEngineStep); });
        }
    }
    for (const auto& run : runs)
    {
        study.points.push_back(run());
        const ErrorPoint& point = study.points.back();
        progress(study.points.size(), runs.size(), point.curve + ", " + point.setting);
    }
    return study;
}

} // namespace frostfill
