// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/error.hpp>

#include <pybind11/pybind11.h>

namespace frostfill::python
{

/// Adds frostfill.Error and a class for each kind of it, and makes them of what the library throws.
void addErrors(pybind11::module_& module);

/// The class of a kind of error.
[[nodiscard]] pybind11::object errorClass(ErrorCode code);

} // namespace frostfill::python
