// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/renderer.hpp>
#include <frostfill/run_file.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#pragma GCC visibility push(default)
namespace frostfill
{

/// The scene with which `fill` began a run that is kept. Throws Error badData for a run file of
/// something else.
[[nodiscard]] Scene sceneOfRun(const RunFileReader& run);

/// How `render` draws a picture of a kept run: as `scene` says, the scene of the run with other
/// frames, picture or camera. The last picture alone of a mesh that is not built in has one colour
/// for all spheres, unless `scene` asks for a column. Colours have the range of the whole run, and
/// a moving object fits at all times. Throws Error badData like sceneOfRun.
[[nodiscard]] RenderSettings pictureSettings(const RunFileReader& run, const Scene& scene);

/// The same for a simulation that is under way, whose scene is `scene`.
[[nodiscard]] RenderSettings pictureSettings(const Simulation& simulation, const Scene& scene);

} // namespace frostfill
#pragma GCC visibility pop
