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
    void advance(RunningSpheres& running, double gravity, double dt) override
    {
        const double fall = gravity * dt;
        for (std::uint32_t i = 0; i < running.size(); ++i)
        {
            const Eigen::Vector3d velocity = running.velocity[i];
            const Eigen::Vector3d faster = velocity - Eigen::Vector3d(0, fall, 0);
            running.position[i] += (isExplicit_ ? velocity : faster) * dt;
            running.velocity[i] = faster;
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
