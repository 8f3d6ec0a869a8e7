// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

/// The half width of the studio's lamp, seen from anywhere. [1] By so much its light spreads on the
/// way: it is as soft as it is large. As in sphere.frag.
inline constexpr float kLampSoftness = 0.3F;

} // namespace frostfill
