// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/run_file.hpp>

namespace frostfill
{

/// The run file's name in the directory of a run; see fileOfRun.
inline constexpr const char* kRunFile = "run.frost";
/// The same of a run that is simulated before its first frame is kept: its head and its mesh alone.
inline constexpr const char* kBegunFile = "begun.frost";

} // namespace frostfill
