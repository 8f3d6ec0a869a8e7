// SPDX-License-Identifier: MIT
#include "simulation/quality/quality.hpp"
#include "study/error/error_finish.hpp"
#include "study/error/error_runs.hpp"
#include "study/peers/pouring.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr double kShareOfCube = 0.4;   // of the cube: above a pile, others need room to pour
constexpr double kLiggghtsLimit = 300; // of processor time [s]

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

/// Judges places alone, of any engine: how many spheres would move if all were free.
ErrorPoint judged(const PeerTask& task, const std::vector<Eigen::Vector3d>& places)
{
    const std::vector<double> radii(places.size(), 1);
    const std::vector<bool> atRest(places.size(), true);
    const QualityReport quality =
        examine(task.mesh, places, radii, atRest, Axis::y, {.friction = task.friction});
    const EquilibriumReport& balance = quality.equilibrium.value();
    const auto spheres = static_cast<double>(balance.spheres);
    ErrorPoint point;
    point.study = "rest";
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

ErrorPoint restOfLiggghts(const PeerTask& task, double stiffness, double still)
{
    const PeerResult result = runLiggghts(task, stiffness, still);
    ErrorPoint point = judged(task, result.places);
    point.curve = "LIGGGHTS";
    point.setting = fmt::format("stiffness {:g}, still below {:g} r", stiffness, still);
    point.seconds = result.seconds;
    point.details.push_back(result.atRest ? 1 : 0);
    return point;
}

} // namespace

void addRestRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    PeerTask task;
    task.count = quick ? 300 : 1000;
    task.mesh = cubeFilledTo(kShareOfCube, task.count);
    task.restitution = kPeerRestitution;
    task.secondsLimit = kLiggghtsLimit;
    const bool comparesLiggghts = hasLiggghts();
    for (const double friction : {0.0, 0.3})
    {
        task.friction = friction;
        for (const RestMethod& method : kRestMethods)
        {
            if (friction > 0 || !method.needsFriction)
            {
                tasks.emplace_back([=] { return ourRest(task, method); });
            }
        }
        for (const double stiffness : {4.5e4, 4.5e3})
        {
            for (const double still : {kPeerStill, kPeerStill / 100})
            {
                if (comparesLiggghts && (!quick || stiffness > 1e4))
                {
                    tasks.emplace_back([=] { return restOfLiggghts(task, stiffness, still); });
                }
            }
        }
    }
}

} // namespace frostfill
