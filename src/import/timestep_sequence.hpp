// SPDX-License-Identifier: MIT
#pragma once

#include "packing/timestep_reader.hpp"

#include <frostfill/import.hpp>

#include <cstddef>
#include <optional>

namespace frostfill
{

/// The timesteps of a file with their times, none before the last, and an id for every sphere.
class TimestepSequence
{
public:
    explicit TimestepSequence(const ImportRequest& request);

    /// The next timestep; false after the last. A step that is there twice, as where two dumps were
    /// joined, counts once. Throws Error badData for steps that go back and for a dump of several
    /// steps without ids, usage for one without times.
    [[nodiscard]] bool next(Timestep& timestep);
    [[nodiscard]] double time() const { return time_; }            ///< [s] of the timestep
    [[nodiscard]] std::size_t index() const { return count_ - 1; } ///< of the timestep
    [[nodiscard]] std::size_t repeats() const { return repeats_; } ///< left out so far
    [[nodiscard]] const TimestepReader& reader() const { return reader_; }

private:
    void nameSpheres(Timestep& timestep) const;
    [[nodiscard]] double timeOf(const Timestep& timestep) const;

    const ImportRequest& request_;
    TimestepReader reader_;
    std::size_t count_ = 0; ///< timesteps so far
    std::size_t repeats_ = 0;
    double time_ = 0;
    std::optional<std::uint64_t> step_;
};

} // namespace frostfill
