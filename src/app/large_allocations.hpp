// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

/// Keeps memory that is freed for the next array, up to some tens of megabytes. Called once, before
/// anything large is allocated.
void useMemoryAgain();

} // namespace frostfill
