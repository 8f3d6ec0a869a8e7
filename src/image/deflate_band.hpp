// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace frostfill
{

/// Appends a deflate stream without an end, padded to a whole byte. Equal data gives equal bytes,
/// whatever the thread and wherever the memory lies. Throws Error outOfMemory.
void deflateBand(const std::vector<std::uint8_t>& data, std::vector<std::uint8_t>& out);

} // namespace frostfill
