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
    void advance(Spheres& spheres, std::size_t begin, double gravity, double dt) override
    {
        const Eigen::Vector3d change = {0, -gravity * dt, 0};
        for (std::size_t i = begin; i < spheres.size(); ++i)
        {
            const Eigen::Vector3d before = spheres.velocity(i);
            spheres.setPosition(i, spheres.position(i) + (before + change / 2) * dt);
            spheres.setVelocity(i, before + change);
        }
    }
};

[[maybe_unused]] const Integrator kMidpoint =
    integrators().add("midpoint", [] { return std::make_unique<Midpoint>(); });

} // namespace
} // namespace frostfill
