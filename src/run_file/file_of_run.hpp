// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/run_file.hpp>

namespace frostfill
{

/// The run file's name in the directory of a run; see fileOfRun.
inline constexpr const char* kRunFile = "run.frost";
/// The same of a run that is simulated before its first frame is kept.
inline constexpr const char* kBegunFile = "begun.frost";
/// The name of the file with the states of a run that is simulated before its pictures, when no run
/// can begin again by that file.
inline constexpr const char* kStatesFile = "states.frost";

/// Throws Error badData for the file of a run that was killed before its first frame.
void requireFrames(const RunFileReader& reader, const std::filesystem::path& file);

} // namespace frostfill
