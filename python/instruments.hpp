// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace frostfill::python
{

/// Adds the functions that judge packings, inspect meshes and estimate volumes.
void addInstruments(pybind11::module_& module);

} // namespace frostfill::python
