// SPDX-License-Identifier: MIT
#pragma once

#include "study/error/error_study.hpp"

#include <functional>

namespace frostfill
{

/// A point that is still to be measured.
using ErrorTask = std::function<ErrorPoint()>;

/// Time steps and contact sweeps against overlap, energy and support: both presets.
void addStepRuns(std::vector<ErrorTask>& tasks, bool quick);
/// Discards against the run without.
void addDiscardRuns(std::vector<ErrorTask>& tasks, bool quick);
/// Radii against the error of the volume that the spheres tell: the four objects, the cube up to a
/// million spheres, and `more` files.
void addVolumeRuns(std::vector<ErrorTask>& tasks, const std::vector<std::string>& more, bool quick);
/// Layers of spheres in a set against the packing fraction far from walls.
void addLayerRuns(std::vector<ErrorTask>& tasks, bool quick);
/// Spheres that rest each by itself, that have settled together, and those of LIGGGHTS where it is
/// installed: the share that nothing holds when all are let go.
void addRestRuns(std::vector<ErrorTask>& tasks, bool quick);
/// Samples a pixel against a picture of many more, for exact and tessellated spheres.
void addRenderRuns(std::vector<ErrorTask>& tasks, bool quick);
/// The same for the shell, with few and with very many triangles.
void addShellRuns(std::vector<ErrorTask>& tasks, bool quick);

} // namespace frostfill
