// SPDX-License-Identifier: MIT
#include "simulation/quality/equilibrium.hpp"

#include "simulation/quality/joint_balance.hpp"
#include "simulation/quality/least_friction.hpp"
#include "simulation/quality/tolerances.hpp"

namespace frostfill
{
namespace
{

double frictionOf(const World& world)
{
    return world.scene.judge.friction.value_or(0);
}

} // namespace

EquilibriumReport judgeEquilibrium(const World& world)
{
    Threads threads(world.scene.threads);
    const ContactNetwork network = networkAtRest(world, threads);
    const double unbalance = world.scene.judge.unbalance;
    EquilibriumReport report;
    report.friction = frictionOf(world);
    report.spheres = network.bodies.size();
    const Balance balance =
        JointBalance(network, threads).solve(report.friction, {.unbalance = unbalance});
    report.unbalanced = balance.unbalanced;
    report.largest = balance.largest;
    report.settled = balance.settled;
    const auto loose =
        static_cast<std::size_t>(kLoose * static_cast<double>(network.bodies.size()));
    report.leastFriction = leastFriction(network, unbalance, loose, threads);
    return report;
}

std::vector<double> unbalanceAtRest(const World& world)
{
    Threads threads(world.scene.threads);
    const ContactNetwork network = networkAtRest(world, threads);
    JointBalance forces(network, threads);
    (void)forces.solve(frictionOf(world), {.unbalance = world.scene.judge.unbalance});
    const double noise = kSettledForces * world.scene.judge.unbalance;
    std::vector<double> missing(network.bodies.size());
    for (std::uint32_t body = 0; body < missing.size(); ++body)
    {
        const double found = forces.unbalance(body);
        missing[body] = found > noise ? found : 0;
    }
    return missing;
}

} // namespace frostfill
