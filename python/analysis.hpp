// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace frostfill::python
{

/// Adds the analyses of packings.
void addAnalysis(pybind11::module_& module);

} // namespace frostfill::python
