// SPDX-License-Identifier: MIT
#include "simulation/motion/integrator.hpp"

namespace frostfill
{
namespace
{

/// Euler's method. The position follows the velocity before the step (explicit) or after it
/// (semi-implicit).
class Euler final : public IntegratorPart
{
public:
    explicit Euler(bool isExplicit) : isExplicit_(isExplicit) {}
    void advance(Spheres& spheres, std::size_t begin, double gravity, double dt) override
    {
        const double fall = gravity * dt;
        for (std::size_t i = begin; i < spheres.size(); ++i)
        {
            const Eigen::Vector3d velocity = spheres.velocity(i);
            const Eigen::Vector3d faster = velocity - Eigen::Vector3d(0, fall, 0);
            spheres.setPosition(i, spheres.position(i) + (isExplicit_ ? velocity : faster) * dt);
            spheres.setVelocity(i, faster);
        }
    }

private:
    bool isExplicit_;
};

} // namespace

PartTable<Integrator, MakeIntegrator>& integrators()
{
    static PartTable<Integrator, MakeIntegrator> table = {
        [] { return std::make_unique<Euler>(true); },  // explicit
        [] { return std::make_unique<Euler>(false); }, // semi-implicit
    };
    return table;
}

} // namespace frostfill
