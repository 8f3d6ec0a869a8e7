// SPDX-License-Identifier: MIT
#include "simulation/quality/least_friction.hpp"

#include "simulation/quality/joint_balance.hpp"
#include "simulation/quality/tolerances.hpp"

#include <algorithm>
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

} // namespace frostfill
