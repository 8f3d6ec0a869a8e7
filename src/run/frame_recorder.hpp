// SPDX-License-Identifier: MIT
#pragma once

#include "run/falling_spheres.hpp"
#include "run/frame_drawer.hpp"
#include "run/frame_timing.hpp"

#include <frostfill/run_file.hpp>
#include <frostfill/simulation.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace frostfill
{

/// A run as its recorder sees it, at one of its states.
class RunStates
{
public:
    virtual ~RunStates() = default;
    [[nodiscard]] virtual double time() const = 0;            ///< [s] simulated
    [[nodiscard]] virtual std::uint64_t revision() const = 0; ///< grows with each change
    [[nodiscard]] virtual std::size_t sphereCount() const = 0;
    /// Exact where the sphere is at rest.
    [[nodiscard]] virtual SphereRecord sphere(std::size_t id) const = 0;
    /// See Simulation::capture. Names at least what has changed since the last capture.
    virtual void capture(Snapshot& snapshot) = 0;
};

/// As it is simulated.
class LiveStates final : public RunStates
{
public:
    explicit LiveStates(const Simulation& simulation) : simulation_(simulation) {}
    [[nodiscard]] double time() const override { return simulation_.time(); }
    [[nodiscard]] std::uint64_t revision() const override { return simulation_.revision(); }
    [[nodiscard]] std::size_t sphereCount() const override { return simulation_.sphereCount(); }
    [[nodiscard]] SphereRecord sphere(std::size_t id) const override
    {
        return simulation_.sphere(id);
    }
    void capture(Snapshot& snapshot) override { simulation_.capture(snapshot); }

private:
    const Simulation& simulation_;
};

/// As it was simulated before its pictures, and kept step by step in a run file.
class KeptStates final : public RunStates
{
public:
    explicit KeptStates(const std::filesystem::path& file) : reader_(file) { seek(0); }
    [[nodiscard]] std::size_t count() const { return reader_.frames().size(); }
    /// Goes on to a state.
    void seek(std::size_t index) { now_ = &reader_.seek(index); }
    [[nodiscard]] double time() const override { return now_->time; }
    [[nodiscard]] std::uint64_t revision() const override { return reader_.revision(); }
    [[nodiscard]] std::size_t sphereCount() const override { return now_->states.size(); }
    [[nodiscard]] SphereRecord sphere(std::size_t id) const override;
    void capture(Snapshot& snapshot) override;

private:
    RunFileReader reader_;
    const Snapshot* now_ = nullptr;
};

/// Looks at a run at the times of frames. What it sees goes to the painter and into the run
/// file. Which frames there are follows from times and counts, never from the clock.
class FrameRecorder
{
public:
    /// `smallestRadius` [mesh unit] is that of the run. Without a painter no pictures are drawn.
    /// If only the last state is of interest, `lastOnly`, no other is looked at.
    FrameRecorder(std::unique_ptr<FramePainter> painter, double smallestRadius, bool lastOnly);

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
    /// Takes the frames that are due. Throws what has gone wrong with an earlier one.
    void record(RunStates& run);
    /// Takes the last state; see FramePainter::finish.
    void finish(RunStates& run, const std::function<void()>& taken = {});

    /// Null without pictures.
    [[nodiscard]] const FramePainter* painter() const { return painter_.get(); }
    /// Null if none is kept.
    [[nodiscard]] RunFileWriter* file() { return file_.get(); }
    /// Of the last state, after finish().
    [[nodiscard]] std::size_t lastNumber() const { return next_; }
    /// Pictures so far.
    [[nodiscard]] std::size_t count() const { return painter_ ? painter_->count() : 0; }
    [[nodiscard]] std::size_t stride() const { return painter_ ? painter_->stride() : 1; }

private:
    [[nodiscard]] double timeAt(std::size_t frame) const;
    void takeNext(RunStates& run);
    void observe(RunStates& run, double time);
    void capture(RunStates& run, double time);
    [[nodiscard]] FramePainter::State state();

    std::unique_ptr<RunFileWriter> file_;
    double smallestRadius_;
    bool lastOnly_;
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

} // namespace frostfill
