// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace frostfill
{

/// Memory of this machine, or what the process may have of it [bytes].
[[nodiscard]] double memoryAtHand();

/// Whether the process may still map so much: a limit on its address space leaves it.
[[nodiscard]] bool mayMap(std::size_t bytes);

} // namespace frostfill
