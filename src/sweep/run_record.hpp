// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/sweep.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace frostfill
{

[[nodiscard]] inline RunReport failed(const Error& error)
{
    return {RunStatus::failed, static_cast<int>(error.code()), error.what()};
}

/// What a sweep notes beside the files of a run, in sweep.json: a run that was refused writes
/// nothing else.
struct RunNote
{
    RunReport report;
    std::string runHash; ///< of the run that the note is about; empty if its mesh was not read
    double seconds = 0;  ///< since it began, wall-clock
};

/// Throws Error cannotCreate or writeFailed.
void writeNote(const std::filesystem::path& folder, const RunNote& note);

/// Empty if there is none.
[[nodiscard]] std::optional<RunNote> readNote(const std::filesystem::path& folder);

} // namespace frostfill
