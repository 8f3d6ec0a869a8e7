// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/run_file.hpp>

namespace frostfill
{

/// The run file's name in the directory of a run; see fileOfRun.
inline constexpr const char* kRunFile = "run.frost";

} // namespace frostfill
