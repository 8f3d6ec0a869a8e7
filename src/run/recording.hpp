// SPDX-License-Identifier: MIT
#pragma once

#include "run/camera_path.hpp"
#include "run/falling_spheres.hpp"
#include "run/frame_painter.hpp"
#include "run/frame_timing.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/run_file.hpp>
#include <frostfill/simulation.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace frostfill
{

/// A run as its recorder sees it, at one of its states.
struct RunState
{
    double time;                            ///< [s] simulated
    std::uint64_t revision;                 ///< grows with each change
    std::size_t spheres;                    ///< their number
    ExactSphere exact;                      ///< where the sphere is at rest
    std::function<void(Snapshot&)> capture; ///< see Simulation::capture
};

/// Returns the run as it is simulated, until its next step.
[[nodiscard]] RunState stateOf(const Simulation& simulation);

/// A run that was simulated before its pictures, and kept step by step in a run file.
class KeptStates
{
public:
    explicit KeptStates(const std::filesystem::path& file) : reader_(file) {}
    [[nodiscard]] std::size_t count() const { return reader_.frames().size(); }
    /// Returns a state, until the next call. Its capture names at least what has changed since the
    /// last one.
    [[nodiscard]] RunState at(std::size_t index);

private:
    RunFileReader reader_;
};

/// Looks at a run at the times of frames. What it sees goes to the painter and into the run
/// file. Which frames there are follows from times and counts, never from the clock.
class FrameRecorder
{
public:
    /// `smallestRadius` [mesh unit] is that of the run. Without a painter no pictures are drawn.
    FrameRecorder(std::unique_ptr<FramePainter> painter, double smallestRadius);

    /// Takes over which times become frames, and which of these pictures. Before it only the first
    /// frame is due, that of the start.
    void keepTo(const FramePlan& plan);
    /// Draws falls that the motion leaves out.
    void drawFalls(std::unique_ptr<FallingSpheres> falls) { falls_ = std::move(falls); }
    /// Asks the run for these columns. To be called before the first frame.
    void carry(const std::vector<ColumnValues>& columns);
    /// Keeps every frame in a file. To be called before the first.
    void keepIn(std::unique_ptr<RunFileWriter> file);
    /// Asks this between frames, of which one step may be due many; once it is true, those of the
    /// step and those for which the last state is held are left out.
    void stopWhen(std::function<bool()> requested);
    /// Takes the frames that are due. Where only the last state is of interest this is not called.
    /// Throws what has gone wrong with an earlier one.
    void record(const RunState& run);
    /// Keeps this state in the file as the next frame, whatever its time.
    void keep(const RunState& run);
    /// Takes the last state; see FramePainter::finish.
    void finish(const RunState& run, const std::function<void()>& taken = {});

    /// Null without pictures.
    [[nodiscard]] const FramePainter* painter() const { return painter_.get(); }
    /// Null if none is kept.
    [[nodiscard]] RunFileWriter* file() { return file_.get(); }
    /// Of the last state, after finish().
    [[nodiscard]] std::size_t lastNumber() const { return next_; }
    /// Pictures so far.
    [[nodiscard]] std::size_t count() const { return painter_ ? painter_->plan().count() : 0; }
    [[nodiscard]] std::size_t stride() const { return painter_ ? painter_->plan().stride() : 1; }

private:
    [[nodiscard]] double timeAt(std::size_t frame) const;
    void takeNext(const RunState& run);
    void observe(const RunState& run, double time);
    void capture(const RunState& run, double time);
    [[nodiscard]] const Snapshot& newest();

    std::unique_ptr<RunFileWriter> file_;
    double smallestRadius_;
    std::function<bool()> stopRequested_;
    double interval_ = FrameTiming{}.interval;
    std::unique_ptr<FallingSpheres> falls_;
    bool over_ = false;                 ///< nothing falls any more
    std::size_t next_ = 0;              ///< number of the frame that is due next
    std::uint64_t seen_ = ~0ULL;        ///< revision of the run in the newest snapshot
    std::uint64_t revision_ = 0;        ///< of what pictures see, falls included
    std::array<Snapshot, 3> snapshots_; ///< one is filled, one waits, one is being drawn
    std::array<std::size_t, 3> real_{}; ///< spheres of each that the run has, if falls are drawn
    std::size_t newest_ = 0;            ///< in snapshots_
    bool isGiven_ = true;               ///< the painter has the newest, and may be drawing it
    /// Goes first: it may be drawing a snapshot when a failed write ends the run.
    std::unique_ptr<FramePainter> painter_;
};

/// Whether the run is kept in a run file.
[[nodiscard]] bool isKept(const Scene& scene);

/// The recorder of a run, with a painter if it has pictures. Null if no frames are wanted. See
/// FrameRecorder::stopWhen. Throws Error; see FramePainter.
[[nodiscard]] std::unique_ptr<FrameRecorder>
makeRecorder(const FillRequest& request, const LoadedMesh& mesh, const Simulation& simulation,
             const std::optional<CameraPath>& path, std::function<bool()> stopRequested);

/// What the recorder of a run carries besides the columns that every snapshot has.
[[nodiscard]] std::vector<ColumnValues> columnsToCarry(const Scene& scene);

/// Whether the times that become frames depend on the length of the run.
[[nodiscard]] bool lengthMatters(const Scene& scene);

/// Which times become frames of a run of this length, which need not be known if it does not
/// matter. `path` [s] is the duration of the camera's. Throws Error usage when no picture is left
/// of those asked for.
[[nodiscard]] FramePlan planPictures(const Scene& scene, const MeshReport& mesh,
                                     const RunLength& length, double path);

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
    /// Keeps states in the file.
    [[nodiscard]] FrameRecorder& states() { return states_; }
    /// Leaves the file behind, if a run can begin again by it.
    void stay();

private:
    std::filesystem::path path_;
    FrameRecorder states_;
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
    /// Places where spheres appear, if the motion leaves out the falls.
    std::vector<Landing> landings;
};

/// Steps to the end, or until the caller wants to stop, and keeps each state: as frame by frame,
/// and the one at the end once more, with what the end has discarded. Throws Error writeFailed.
[[nodiscard]] SimulatedRun simulateInto(FrameRecorder& states, Simulation& simulation,
                                        const FillRequest& request, const FillObserver& observer);

/// Shows the states of a run that was simulated to the recorder, as simulate() would have, and
/// leaves the last for its end. `simulation` is at its end, and `pictures` are expected.
[[nodiscard]] RunEnd replay(RunEnd end, KeptStates& states, FrameRecorder& recorder,
                            const Simulation& simulation, const FillObserver& observer,
                            std::size_t pictures);

} // namespace frostfill
