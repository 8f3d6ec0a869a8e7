// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace frostfill::python
{

/// Adds the class of kept runs, and what makes one.
void addRun(pybind11::module_& module);

} // namespace frostfill::python
