// SPDX-License-Identifier: MIT
#pragma once

#include "run_file/frame_codec.hpp"
#include "run_file/run_states.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{

/// Every state of a run, as a recorder would see it, for a run whose pictures depend on its length:
/// it is simulated once, and its pictures are made from the tape when the length is known. It holds
/// what a run file holds, of each step and not of each frame.
class StateTape
{
public:
    /// Bytes of all states; the cube with 11,000 spheres that fall takes 7 MB. Larger: a run of
    /// very short steps takes more memory than it need. Smaller: more of them are simulated twice.
    static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

    /// `columns` are those that the recorder carries.
    /// `smallestRadius` [mesh unit] is that of the run.
    StateTape(std::vector<ColumnValues> columns, double smallestRadius,
              std::size_t mostBytes = kMostBytes);
    /// Takes the state as it is now. Once the tape is full it is given up.
    void add(const RunStates& run);
    [[nodiscard]] bool isFull() const { return isFull_; }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

private:
    friend class TapeReader;
    struct Part
    {
        std::string streams;
        std::vector<std::uint64_t> revisions; ///< of its states
    };
    void endPart();

    std::size_t mostBytes_;
    Snapshot seen_;
    double smallestRadius_;
    std::optional<FrameEncoder> encoder_;
    std::vector<std::uint64_t> revisions_; ///< of the states that wait in the encoder
    std::deque<Part> parts_;
    std::size_t bytes_ = 0; ///< of the parts
    bool isFull_ = false;
};

/// Goes through a tape once, from its beginning, and frees what it has passed.
class TapeReader final : public RunStates
{
public:
    explicit TapeReader(StateTape tape);
    /// Goes to the next state; to the first at first. False behind the last.
    bool next();
    [[nodiscard]] double time() const override { return now().time; }
    [[nodiscard]] std::uint64_t revision() const override { return revision_; }
    [[nodiscard]] std::size_t sphereCount() const override { return now().states.size(); }
    [[nodiscard]] SphereRecord sphere(std::size_t id) const override;
    void capture(Snapshot& snapshot) const override;

private:
    [[nodiscard]] const Snapshot& now() const { return decoder_.snapshot(); }
    void noteChanges();

    StateTape tape_;
    FrameDecoder decoder_;
    StreamReaders streams_; ///< of the first part
    std::size_t read_ = 0;  ///< states of it
    std::uint64_t revision_ = 0;
    std::size_t state_ = 0;            ///< number of this state, from 1
    std::vector<std::size_t> changed_; ///< by sphere: the state that changed it last
};

} // namespace frostfill
