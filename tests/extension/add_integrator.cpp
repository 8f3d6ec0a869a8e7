// SPDX-License-Identifier: MIT
#include "simulation/motion/integrator.hpp"

namespace frostfill
{
namespace
{

/// The midpoint rule, which is exact for a free fall.
class Midpoint final : public IntegratorPart
{
public:
    void advance(RunningSpheres& running, double gravity, double dt) override
    {
        const Eigen::Vector3d change = {0, -gravity * dt, 0};
        for (std::uint32_t row = 0; row < running.size(); ++row)
        {
            running.position[row] += (running.velocity[row] + change / 2) * dt;
            running.velocity[row] += change;
        }
    }
};

[[maybe_unused]] const Integrator kMidpoint =
    integrators().add("midpoint", [] { return std::make_unique<Midpoint>(); });

} // namespace
} // namespace frostfill
