// SPDX-License-Identifier: MIT
#include "run/run_length.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Spheres of a run that is its own trial, and of the model of a larger one, which has a tenth of
/// them at most: a trial beside the run takes no more than a tenth of its time. Larger: pictures
/// begin later. Smaller: more runs whose length is known only roughly.
constexpr double kTrialSpheres = 30000;
constexpr double kTrialSpheresPaper = 10000;
constexpr double kTrialSpheresGranular = 500;  // slow
constexpr double kTrialSpheresDescent = 50000; // quick
/// Steps of the motion descend, however many spheres; see DropAndRollEngine.
constexpr double kStepsOfDescent = 200;
constexpr double kModel = 3000;
constexpr double kModelPaper = 1000;

/// How the time of a set goes with the size of its spheres, with as many sets: r to this power.
/// Where spheres fall, larger sets of smaller spheres lie deeper and settle longer: by runs of the
/// cube with 5,000, 10,000 and 20,000 spheres. Where they do not, a set takes some sqrt(r/g).
constexpr double kGrowthOfFalls = -0.7;
constexpr double kGrowthOfSettling = 0.5;

/// Enters the spheres that appeared in the last step, one after the other.
void enterLandings(const Simulation& simulation, double before, std::vector<Landing>& landings)
{
    const std::size_t known = std::min(landings.size(), simulation.sphereCount());
    landings.resize(known);
    const auto fresh = static_cast<double>(simulation.sphereCount() - known);
    for (std::size_t id = known; id < simulation.sphereCount(); ++id)
    {
        const SphereRecord sphere = simulation.sphere(id);
        const double share = static_cast<double>(id - known + 1) / fresh;
        landings.push_back({before + share * (simulation.time() - before), sphere.centre,
                            sphere.radius, sphere.group});
    }
}

RunLength lengthOf(const Scene& scene, Simulation& simulation,
                   const std::function<bool()>& stopRequested)
{
    simulation.stopWhen(stopRequested);
    LengthWatch watch(scene);
    while (simulation.step() && !(stopRequested && stopRequested()))
    {
        watch.look(simulation);
    }
    return watch.take();
}

bool descends(const Scene& scene)
{
    return scene.preset != Preset::paper && scene.motion.mode == Motion::descend;
}

/// The same run without what changes nothing in it but takes time, or memory.
Scene withoutExtras(const Scene& scene)
{
    Scene bare = scene;
    if (scene.motion.mode != Motion::granular)
    {
        bare.rest = {}; // takes longer than the filling, for few seconds that are shown of it
    }
    // They find the same pairs in the same order.
    if (scene.search.spheres == SphereSearch::allPairs)
    {
        bare.search.spheres = SphereSearch::grid;
    }
    if (scene.search.polygons <= PolygonSearch::quadtree)
    {
        bare.search.polygons = PolygonSearch::grid;
    }
    return bare;
}

double setsOf(const Scene& scene, const Simulation& simulation)
{
    const auto set = static_cast<double>(simulation.groupSize() * scene.spheres.groupsPerSet);
    return std::max(1.0, std::ceil(static_cast<double>(simulation.expectedSpheres()) / set));
}

/// The scene with its spheres `factor` times as large, and as many fewer. `simulation` is that of
/// the scene, and has not begun.
Scene modelOf(const Scene& scene, const Simulation& simulation, double factor)
{
    Scene model = scene;
    const double share = std::pow(factor, -3);
    model.spheres.sizes = {};
    model.spheres.radius =
        Radii(factor * simulation.smallestRadius(), factor * simulation.radius());
    const auto fewer = [&](auto number)
    {
        return static_cast<decltype(number)>(
            std::max(1.0, std::round(share * static_cast<double>(number))));
    };
    if (scene.spheres.count)
    {
        model.spheres.count = fewer(*scene.spheres.count);
    }
    for (Inlet& inlet : model.spheres.inlets)
    {
        inlet.radius *= factor;
    }
    if (scene.spheres.groupSize > 0)
    {
        model.spheres.groupSize = fewer(scene.spheres.groupSize);
    }
    if (scene.motion.dt)
    {
        model.motion.dt = *scene.motion.dt * std::sqrt(factor);
    }
    return model;
}

} // namespace

bool hasFalls(const Scene& scene)
{
    return scene.preset == Preset::paper || scene.motion.mode == Motion::fall ||
           scene.motion.mode == Motion::granular;
}

bool isItsOwnTrial(const Scene& scene, const Simulation& simulation)
{
    return static_cast<double>(simulation.expectedSpheres()) <=
           (scene.preset == Preset::paper           ? kTrialSpheresPaper
            : scene.motion.mode == Motion::granular ? kTrialSpheresGranular
            : descends(scene)                       ? kTrialSpheresDescent
                                                    : kTrialSpheres);
}

LengthWatch::LengthWatch(const Scene& scene) : falls_(hasFalls(scene))
{
}

void LengthWatch::look(const Simulation& simulation)
{
    if (!falls_)
    {
        enterLandings(simulation, length_.seconds, length_.landings);
    }
    length_.seconds = simulation.time();
}

RunLength estimateRunLength(const Scene& scene, const TriangleMesh& mesh,
                            const Simulation& simulation,
                            const std::function<bool()>& stopRequested)
{
    if (isItsOwnTrial(scene, simulation))
    {
        Simulation same(withoutExtras(scene), simulation);
        return lengthOf(scene, same, stopRequested);
    }
    if (descends(scene))
    {
        return {kStepsOfDescent * simulation.timeStep(), false, {}};
    }
    const auto spheres = static_cast<double>(simulation.expectedSpheres());
    const double spheresOfModel = scene.preset == Preset::paper           ? kModelPaper
                                  : scene.motion.mode == Motion::granular ? kTrialSpheresGranular
                                                                          : kModel;
    const double factor = std::cbrt(spheres / spheresOfModel);
    const Scene smaller = modelOf(withoutExtras(scene), simulation, factor);
    Simulation model(smaller, mesh);
    const double perSet = lengthOf(smaller, model, stopRequested).seconds / setsOf(smaller, model);
    const double growth = std::pow(factor, hasFalls(scene) ? -kGrowthOfFalls : -kGrowthOfSettling);
    return {setsOf(scene, simulation) * perSet * growth, false, {}};
}

} // namespace frostfill
