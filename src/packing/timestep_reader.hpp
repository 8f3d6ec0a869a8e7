// SPDX-License-Identifier: MIT
#pragma once

#include "packing/timestep.hpp"
#include "run_file/mapped_file.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace frostfill
{

/// Whether a text is XYZ: its first line is a number alone.
[[nodiscard]] bool isXyz(std::string_view text);
/// Whether a text is a dump of LAMMPS or LIGGGHTS.
[[nodiscard]] bool isDump(std::string_view text);

/// Whether it is a data file of LAMMPS: its head has a number of atoms.
[[nodiscard]] bool isLammpsData(std::string_view text);

/// Goes through the timesteps of a simulation: a dump or extended XYZ. What a writer that
/// was interrupted has left of its last timestep does not count, not even a last line without its
/// end: a number may lack its last digits.
class TimestepReader
{
public:
    /// `radius` [mesh unit] is that of all spheres where the file has none. Throws Error
    /// inputMissing, or badData for a file that is neither.
    TimestepReader(const std::filesystem::path& file, double radius);

    /// The next timestep; false after the last. Throws Error badData with file and line for a
    /// timestep that cannot be read, has an id twice, or numbers that no sphere has.
    [[nodiscard]] bool next(Timestep& timestep);
    /// Why the end of the file was left out; empty if it was not. Known after the last timestep.
    [[nodiscard]] const std::string& torn() const { return torn_; }
    /// In a few words.
    [[nodiscard]] const char* format() const { return isDump_ ? "a LAMMPS dump" : "XYZ"; }
    [[nodiscard]] bool isDump() const { return isDump_; }

private:
    [[nodiscard]] bool read(Timestep& timestep);
    void examine(const Timestep& timestep) const;

    std::string name_;
    MappedFile mapped_;
    TextLines lines_;
    double radius_;
    bool isDump_;
    std::string torn_;
};

} // namespace frostfill
