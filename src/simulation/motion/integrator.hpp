// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/part_table.hpp"
#include "simulation/world/running_spheres.hpp"

#include <functional>
#include <memory>

namespace frostfill
{

/// An integrator: how free spheres move in a step, before they are tested with anything. Preset
/// paper; the spheres of the preset fast fly ballistically (FreeFlight).
class IntegratorPart
{
public:
    virtual ~IntegratorPart() = default;

    /// Moves all by one step. `gravity`: acceleration downwards along y. Units of the run.
    virtual void advance(RunningSpheres& running, double gravity, double dt) = 0;
};

using MakeIntegrator = std::function<std::unique_ptr<IntegratorPart>()>;

/// Every integrator by its name.
[[nodiscard]] PartTable<Integrator, MakeIntegrator>& integrators();

} // namespace frostfill
