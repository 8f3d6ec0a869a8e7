// SPDX-License-Identifier: MIT
// Runs whose spheres are led astray on purpose.

#include "physics/stress/stress_run.hpp"

#include "lab/meshes.hpp"
#include "simulation/motion/integrator.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

/// Nothing moves, but that every sphere is outside for one step.
class ThereAndBack final : public IntegratorPart
{
public:
    void advance(RunningSpheres& running, double /*gravity*/, double /*dt*/) override
    {
        ++steps_;
        const double far = steps_ == 1 ? 100 : steps_ == 2 ? -100 : 0;
        for (Eigen::Vector3d& position : running.position.all())
        {
            position.x() += far;
        }
    }

private:
    int steps_ = 0;
};

/// Nothing moves at all.
class Still final : public IntegratorPart
{
public:
    void advance(RunningSpheres&, double, double) override {}
};

StressRun runWith(Integrator integrator)
{
    StressRun run;
    run.scene = presetScene(Preset::paper, "cube");
    run.scene.spheres.radius = 0.1;
    run.scene.spheres.count = 1;
    run.scene.motion.integrator = integrator;
    run.mesh = boxMesh({-1, -1, -1}, {1, 1, 1}, 4);
    run.placed = {{{0, 0.3, 0}, 0.1}};
    run.mustRest = false; // in the air
    return run;
}

TEST(StressRun, TellsOfACentreThatWasOutsideAndHasComeBack)
{
    const Integrator still = integrators().add("still", [] { return std::make_unique<Still>(); });
    const Integrator away =
        integrators().add("there-and-back", [] { return std::make_unique<ThereAndBack>(); });
    const StressOutcome stayed = runUnderStress(runWith(still));
    EXPECT_EQ(stayed.verdict, Verdict::passes) << verdictName(stayed.verdict);
    const StressOutcome left = runUnderStress(runWith(away));
    EXPECT_EQ(left.verdict, Verdict::leaks) << verdictName(left.verdict);
    EXPECT_EQ(left.outside, 1u);
    EXPECT_EQ(left.hash, stayed.hash) << "it is where it was";
}

} // namespace
} // namespace frostfill
