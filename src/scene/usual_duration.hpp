// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

/// [s] of video, for which an animation lasts unless the scene says otherwise.
inline constexpr double kUsualDuration = 20;

} // namespace frostfill
