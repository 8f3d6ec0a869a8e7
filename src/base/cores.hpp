// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

/// Cores that this process may use, at least 1: the smallest of the machine's, those it is bound
/// to, the quota of its control group, and what Slurm has given to its task.
[[nodiscard]] int coresAtHand();

} // namespace frostfill
