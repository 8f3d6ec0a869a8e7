// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/snapshot.hpp>

#include <pybind11/pybind11.h>

#include <vector>

namespace frostfill::python
{

/// A state of a run as Python sees it. Arrays of it are views that keep it alive, so it never
/// changes as long as anybody has it or one of its arrays.
struct State
{
    Snapshot snapshot;
    std::vector<Eigen::Vector3d> centres; ///< [#S] mesh coordinates, full precision
    std::vector<double> radii;            ///< [#S]
    std::size_t frame = 0;                ///< its number, in a run that was kept
};

void addState(pybind11::module_& module);

} // namespace frostfill::python
