// SPDX-License-Identifier: MIT
#pragma once

#include "run/run_directory.hpp"

#include <frostfill/fill.hpp>

#include <optional>
#include <string>

namespace frostfill
{

/// The mesh of the run that the directory holds, as it is simulated; empty if none is kept there.
/// Throws Error badData or usage for a run of another version or another scene, with which the
/// request cannot go on.
[[nodiscard]] std::optional<LoadedMesh> meshOfEarlierRun(const FillRequest& request);

/// The first setting by which two scenes give different runs, "seed = 1, not 2"; empty if there is
/// none. The number of threads and similar options change no bit.
[[nodiscard]] std::string sceneDifference(const Scene& begun, const Scene& now);

/// What to do with the files in the directory of a request; `resumes`: with a run that is kept.
[[nodiscard]] EarlierRun earlierFiles(const FillRequest& request, bool resumes);

} // namespace frostfill
