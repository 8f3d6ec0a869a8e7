// SPDX-License-Identifier: MIT
#include "oracle/motion.hpp"
#include "support/shapes.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

constexpr double kG = 9.81;

// One sphere of 5 cm in a box of 10 m, so that it falls freely for a second and more.
struct FreeFall : ::testing::TestWithParam<Integrator>
{
    FreeFall()
    {
        scene = presetScene(Preset::paper, "torus");
        scene.motion.integrator = GetParam();
        scene.motion.dt = 1e-3;
        scene.spheres.radius = 0.05;
        scene.spheres.count = 1;
        scene.spheres.groupSize = 1;
        scene.spheres.groupsPerSet = 1;
    }
    Scene scene;
};

TEST_P(FreeFall, HasExactlyTheErrorOfItsIntegrator)
{
    Simulation simulation(scene, shapes::box({-1, -10, -1}, {1, 0, 1}));
    simulation.step();
    const double sign = GetParam() == Integrator::explicitEuler ? 1 : -1;
    const double dt = simulation.timeStep();
    const double start = simulation.sphere(0).centre.y() - (sign - 1) / 2 * kG * dt * dt;
    for (int step = 2; step <= 1000; ++step)
    {
        simulation.step();
        const double t = step * dt;
        const double expected = start + kG * (sign * oracle::eulerLag(t, dt) - oracle::fall(t));
        ASSERT_NEAR(simulation.sphere(0).centre.y(), expected, 1e-12) << "step " << step;
    }
}

std::string nameOfIntegrator(const ::testing::TestParamInfo<Integrator>& info)
{
    return info.param == Integrator::explicitEuler ? "ExplicitEuler" : "SemiImplicitEuler";
}

INSTANTIATE_TEST_SUITE_P(BothIntegrators, FreeFall,
                         ::testing::Values(Integrator::explicitEuler,
                                           Integrator::semiImplicitEuler),
                         nameOfIntegrator);

} // namespace
} // namespace frostfill
