// SPDX-License-Identifier: MIT
#pragma once

#include "run/camera_path.hpp"
#include "run/frame_recorder.hpp"
#include "run_file/state_tape.hpp"

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

/// What the recorder of a run carries besides the columns that every snapshot has.
[[nodiscard]] std::vector<ColumnValues> columnsToCarry(const Scene& scene);

/// Whether the times that become frames depend on the length of the run.
[[nodiscard]] bool lengthMatters(const Scene& scene);

/// Which times become frames of a run of this length, which need not be known if it does not
/// matter. Tells the recorder, if there is one. `path` [s] is the duration of the camera's. Throws
/// Error usage when no picture is left of those asked for.
[[nodiscard]] FramePlan planPictures(const Scene& scene, const LoadedMesh& mesh,
                                     const RunLength& length, FrameRecorder* recorder, double path);

/// Begins the run file, or continues that of a run that is resumed. Throws Error cannotCreate or
/// writeFailed.
void keepRun(FrameRecorder& recorder, const FillRequest& request, const LoadedMesh& mesh,
             const Simulation& simulation, const FramePlan& frames);

/// Keeps a run, from before its first step until its run file is there, in a file that goes with
/// this object: a run that is killed meanwhile can begin again. Other files stay as they are.
class BegunRun
{
public:
    explicit BegunRun(std::filesystem::path directory) : directory_(std::move(directory)) {}
    ~BegunRun();
    BegunRun(const BegunRun&) = delete;
    BegunRun& operator=(const BegunRun&) = delete;

    /// Throws Error cannotCreate or writeFailed.
    void keep(const FillRequest& request, const LoadedMesh& mesh,
              const Simulation& simulation) const;

private:
    std::filesystem::path directory_;
};

enum class RunEnd
{
    itself,
    stopped,
    overfull ///< until full, and yet the spheres take more than the object: it would never end
};

/// Steps to the end, or until the caller wants to stop, and shows each state to the recorder, if
/// there is one.
[[nodiscard]] RunEnd simulate(Simulation& simulation, FrameRecorder* recorder,
                              const FillRequest& request, const FillObserver& observer);

/// A run that was simulated before its pictures, because they depend on its length.
struct TapedRun
{
    RunEnd end = RunEnd::itself;
    RunLength length;
    StateTape tape; ///< may be full
};

/// Steps to the end, or until the caller wants to stop, and keeps the states. When they take too
/// much memory, the length is told all the same, and `simulation` is at its start again unless the
/// caller wants to stop.
[[nodiscard]] TapedRun simulateToTape(Simulation& simulation, const FillRequest& request,
                                      const FillObserver& observer,
                                      std::size_t mostBytes = StateTape::kMostBytes);

/// Shows the states of a tape to the recorder, as simulate() would have. `simulation` is at its
/// end, and `pictures` are expected.
[[nodiscard]] RunEnd replay(TapedRun run, FrameRecorder& recorder, const Simulation& simulation,
                            const FillObserver& observer, std::size_t pictures);

} // namespace frostfill
