// SPDX-License-Identifier: MIT
#include "simulation/quality/equilibrium.hpp"

#include "simulation/quality/joint_balance.hpp"
#include "simulation/quality/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{

// Each search begins with the forces of the one before.
double leastFriction(const ContactNetwork& network, double unbalance, std::size_t except,
                     Threads& threads)
{
    JointBalance forces(network, threads);
    const BalanceGoal goal = {unbalance, except, true};
    const auto stands = [&](double friction)
    { return forces.solve(friction, goal).unbalanced <= except; };
    if (stands(0))
    {
        return 0;
    }
    double falls = 0;
    double holds = 1;
    while (!stands(holds))
    {
        falls = holds;
        holds *= 2;
        if (holds > JudgeSettings::kMostFriction)
        {
            return std::numeric_limits<double>::infinity();
        }
    }
    while (holds - falls > std::max(kFrictionStep * holds, kLeastFriction))
    {
        const double middle = (falls + holds) / 2;
        (stands(middle) ? holds : falls) = middle;
    }
    return holds;
}

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

ContactForces forcesAtRest(const World& world)
{
    Threads threads(world.scene.threads);
    const ContactNetwork network = networkAtRest(world, threads);
    JointBalance forces(network, threads);
    ContactForces found;
    found.missing =
        forces.solve(frictionOf(world), {.unbalance = world.scene.judge.unbalance}).largest;
    double weight = 0;
    for (const ContactNetwork::Body& body : network.bodies)
    {
        weight += std::pow(body.radius, 3) / static_cast<double>(network.bodies.size());
    }
    const SphereGrid& resting = world.spheres.resting();
    for (std::size_t k = 0; k < network.contacts.size(); ++k)
    {
        const auto& [normal, upon, from] = network.contacts[k];
        if (from != ContactNetwork::kWall)
        {
            found.pairs.push_back({resting.id(upon), resting.id(from), forces.force(k) / weight});
        }
    }
    return found;
}

} // namespace frostfill
