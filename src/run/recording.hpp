// SPDX-License-Identifier: MIT
#pragma once

#include "run/camera_path.hpp"
#include "run/frame_recorder.hpp"

#include <frostfill/fill.hpp>

#include <memory>
#include <optional>

namespace frostfill
{

/// Whether the run is kept in a run file.
[[nodiscard]] bool isKept(const Scene& scene);

/// The recorder of a run, with a painter if it has pictures. Null if no frames are wanted. Throws
/// Error; see FramePainter.
[[nodiscard]] std::unique_ptr<FrameRecorder> makeRecorder(const FillRequest& request,
                                                          const LoadedMesh& mesh,
                                                          const Simulation& simulation,
                                                          const std::optional<CameraPath>& path);

/// Which times become frames. Makes a trial run where they depend on its length, and tells the
/// recorder, if there is one. `path` [s] is the duration of the camera's. Throws Error usage when
/// no picture is left of those asked for.
[[nodiscard]] FramePlan planPictures(const Scene& scene, const LoadedMesh& mesh,
                                     const Simulation& simulation, const FillObserver& observer,
                                     FrameRecorder* recorder, double path);

/// Begins the run file, or continues that of a run that is resumed. Throws Error cannotCreate or
/// writeFailed.
void keepRun(FrameRecorder& recorder, const FillRequest& request, const LoadedMesh& mesh,
             const Simulation& simulation, const FramePlan& frames,
             const std::optional<CameraPath>& path);

} // namespace frostfill
