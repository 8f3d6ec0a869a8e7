// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace frostfill::python
{

/// Adds the classes of reports, which are plain values.
void addReports(pybind11::module_& module);

} // namespace frostfill::python
