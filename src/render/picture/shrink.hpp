// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/image.hpp>

namespace frostfill
{

/// A picture `factor` times as small in both directions: each pixel is the mean of a square, with
/// colours counted by their alpha. What is left over at the right and bottom is dropped.
[[nodiscard]] Image shrunk(const Image& image, int factor);

} // namespace frostfill
