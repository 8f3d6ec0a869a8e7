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

/// The file of a run before its pictures begin, which goes with this object: head, mesh and, of a
/// run that is simulated before, its states. A run that is killed meanwhile can begin again, if it
/// is a new one that is kept. Other files stay as they are.
class BegunRun
{
public:
    /// Throws Error cannotCreate or writeFailed.
    BegunRun(const FillRequest& request, const LoadedMesh& mesh, const Simulation& simulation,
             bool isNew);
    ~BegunRun();
    BegunRun(const BegunRun&) = delete;
    BegunRun& operator=(const BegunRun&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] RunFileWriter& file() { return file_; }
    /// Leaves the file behind, if a run can begin again by it.
    void stay();

private:
    std::filesystem::path path_;
    RunFileWriter file_;
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
struct SimulatedRun
{
    RunEnd end = RunEnd::itself;
    RunLength length;
};

/// Steps to the end, or until the caller wants to stop, and keeps each state in a file: as frame
/// by frame, and the one at the end once more, with what the end has discarded. Throws Error
/// writeFailed.
[[nodiscard]] SimulatedRun simulateInto(RunFileWriter& file, Simulation& simulation,
                                        const FillRequest& request, const FillObserver& observer);

/// Shows the states of a run that was simulated to the recorder, as simulate() would have, and
/// leaves the last for its end. `simulation` is at its end, and `pictures` are expected.
[[nodiscard]] RunEnd replay(RunEnd end, KeptStates& states, FrameRecorder& recorder,
                            const Simulation& simulation, const FillObserver& observer,
                            std::size_t pictures);

} // namespace frostfill
