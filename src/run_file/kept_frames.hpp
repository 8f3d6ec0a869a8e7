// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/run_file.hpp>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace frostfill
{

/// Throws Error badData for the file of a run that was killed before its first frame.
void requireFrames(const RunFileReader& reader, const std::filesystem::path& file);

/// The frames of a run file as the recorder saw them: those of the animation, and behind them, once
/// the run has ended, the last state under the next number. That is nearly always the state of the
/// last frame once more.
class KeptFrames
{
public:
    explicit KeptFrames(RunFileReader& reader);

    /// Frames of the animation.
    [[nodiscard]] std::size_t count() const { return numbers_.size() - (ended_ ? 1 : 0); }
    [[nodiscard]] std::size_t number(std::size_t index) const { return numbers_[index]; }
    /// Of the last state; in a run that has not ended, the last of them shows it.
    [[nodiscard]] std::size_t lastNumber() const { return numbers_.back(); }
    /// See RunFileReader::seek; index count() is that of the last state of a run that has ended.
    [[nodiscard]] const Snapshot& state(std::size_t index) { return reader_.seek(index); }
    [[nodiscard]] const Snapshot& last() { return state(numbers_.size() - 1); }
    /// Of these frames, ascending, one for each moment: the first that shows its last state. Steps
    /// longer than the time between frames make several show one state, and the end of a run may
    /// change states without taking time. Reads all of them.
    [[nodiscard]] std::vector<std::size_t> onePerTime(const std::vector<std::size_t>& indices);

private:
    RunFileReader& reader_;
    const std::vector<std::size_t>& numbers_;
    bool ended_;
};

} // namespace frostfill
