// SPDX-License-Identifier: MIT
#include "simulation/quality/force_cone.hpp"

namespace frostfill
{
namespace
{

/// The normal force of the projection. Its slope is that of a sum of squares, of what is cut off:
/// linear between the two normal forces from which nothing is.
double normalForceOf(double along, double across, double roll, const ConeSlopes& slopes)
{
    for (const bool cutsForce : {false, true})
    {
        for (const bool cutsRoll : {false, true})
        {
            const double friction = cutsForce ? slopes.friction : 0;
            const double rolling = cutsRoll ? slopes.rolling : 0;
            const double found = (along + friction * across + rolling * roll) /
                                 (1 + friction * friction + rolling * rolling);
            if (cutsForce == (across > slopes.friction * found) &&
                cutsRoll == (roll > slopes.rolling * found))
            {
                return found;
            }
        }
    }
    return 0; // pushes the other way, or rounding decides
}

Eigen::Vector3d shortened(const Eigen::Vector3d& vector, double length, double most)
{
    return length > most ? Eigen::Vector3d(most / length * vector) : vector;
}

} // namespace

Eigen::Vector3d projectToCone(const Eigen::Vector3d& force, const Eigen::Vector3d& normal,
                              double friction)
{
    const double along = force.dot(normal);
    const Eigen::Vector3d across = force - along * normal;
    const double length = across.norm();
    if (along >= 0 && length <= friction * along)
    {
        return force;
    }
    const double onto = (along + friction * length) / (1 + friction * friction);
    if (onto <= 0)
    {
        return Eigen::Vector3d::Zero();
    }
    const double share = length > 0 ? friction * onto / length : 0;
    return onto * normal + share * across;
}

ContactLoad projectToCone(const ContactLoad& load, const Eigen::Vector3d& normal,
                          const ConeSlopes& slopes)
{
    const double along = load.force.dot(normal);
    const Eigen::Vector3d across = load.force - along * normal;
    const Eigen::Vector3d roll = load.roll - load.roll.dot(normal) * normal;
    const double acrossLength = across.norm();
    const double rollLength = roll.norm();
    const double onto = normalForceOf(along, acrossLength, rollLength, slopes);
    if (onto <= 0)
    {
        return {};
    }
    return {onto * normal + shortened(across, acrossLength, slopes.friction * onto),
            shortened(roll, rollLength, slopes.rolling * onto)};
}

} // namespace frostfill
