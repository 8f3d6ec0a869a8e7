// SPDX-License-Identifier: MIT
#pragma once

#include "study/table.hpp"

#include <frostfill/snapshot.hpp>

namespace frostfill
{

/// A row for every pair of groups i <= j: what Algorithm 1 does with it (both running, one frozen,
/// not tested, one discarded) and how many tests that are.
[[nodiscard]] Table pairTable(const Snapshot& snapshot);

} // namespace frostfill
