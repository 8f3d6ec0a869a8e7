// SPDX-License-Identifier: MIT
#include "simulation/settling/contact_law.hpp"

#include <cmath>
#include <numbers>

namespace frostfill
{

double dampingRatioFor(double restitution)
{
    constexpr int kBisections = 60;
    double low = 0;
    double high = std::numbers::pi / 2;
    for (int k = 0; k < kBisections; ++k)
    {
        const double angle = (low + high) / 2;
        const double leaves = std::exp(-(std::numbers::pi - 2 * angle) * std::tan(angle));
        (leaves > restitution ? low : high) = angle;
    }
    return std::sin(low);
}

} // namespace frostfill
