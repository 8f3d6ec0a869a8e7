// SPDX-License-Identifier: MIT
#include "simulation/quality/equilibrium.hpp"

#include "simulation/quality/joint_balance.hpp"
#include "simulation/quality/tolerances.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace frostfill
{

namespace
{

/// Normals whose area or volume is smaller than this span a line or a plane but for rounding, and
/// fewer of them do as well.
constexpr double kFlat = 1e-9;

} // namespace

// The best that contacts can do, min |pull + sum lambda n| over lambda >= 0, is done by at most
// three of them [Caratheodory]. Every subset that pushes is an upper bound, so the first that
// leaves no more than is allowed proves that the sphere is carried, and only when all of them leave
// more it is not.
bool contactsCanCarry(const Eigen::Vector3d& pull, std::span<const Eigen::Vector3d> normals,
                      double allowed)
{
    const double most = allowed * allowed;
    if (pull.squaredNorm() <= most)
    {
        return true;
    }
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
        const Eigen::Vector3d& a = normals[i];
        const double push = -pull.dot(a);
        if (push > 0 && (pull + push * a).squaredNorm() <= most)
        {
            return true;
        }
    }
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
        const Eigen::Vector3d& a = normals[i];
        for (std::size_t j = 0; j < i; ++j)
        {
            const Eigen::Vector3d& b = normals[j];
            const Eigen::Vector3d axis = a.cross(b);
            const double area = axis.squaredNorm();
            if (area < kFlat * kFlat)
            {
                continue;
            }
            // By Cramer's rule in the plane of the two, and in space for a third.
            const bool pushes = pull.dot(axis.cross(b)) >= 0 && pull.dot(a.cross(axis)) >= 0;
            const double along = pull.dot(axis);
            if (pushes && along * along <= most * area)
            {
                return true;
            }
            for (std::size_t k = 0; k < j; ++k)
            {
                const Eigen::Vector3d& c = normals[k];
                const double volume = axis.dot(c);
                if (std::abs(volume) < kFlat)
                {
                    continue;
                }
                const std::array pushesOf = {-pull.dot(b.cross(c)) / volume,
                                             -pull.dot(c.cross(a)) / volume, -along / volume};
                if (pushesOf[0] >= 0 && pushesOf[1] >= 0 && pushesOf[2] >= 0)
                {
                    return true;
                }
            }
        }
    }
    return false;
}

// As a network of one sphere between walls.
bool frictionCanCarry(const Eigen::Vector3d& pull, std::span<const Eigen::Vector3d> normals,
                      double friction, double allowed, const RollingSupport& rolling)
{
    ContactNetwork network;
    network.rollingFriction = rolling.friction;
    network.bodies.push_back({pull, rolling.radius});
    for (const Eigen::Vector3d& normal : normals)
    {
        network.contacts.push_back({normal, 0, ContactNetwork::kWall});
    }
    network.wallRadii.assign(rolling.below.begin(), rolling.below.end());
    Threads alone(1);
    const BalanceGoal goal{.unbalance = allowed, .except = 0, .ends = true};
    return JointBalance(network, alone).solve(friction, goal).unbalanced == 0;
}

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
    while (holds - falls > kFrictionStep * std::max(holds, 0.1))
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
