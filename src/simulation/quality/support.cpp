// SPDX-License-Identifier: MIT
#include "simulation/quality/support.hpp"

#include "simulation/quality/joint_balance.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

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

} // namespace frostfill
