// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace frostfill::python
{

/// Adds the class Simulation.
void addSimulation(pybind11::module_& module);

} // namespace frostfill::python
