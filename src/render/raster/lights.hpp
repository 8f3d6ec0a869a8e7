// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill::lanes
{

/// Towards a light, in eye space.
struct LightWay
{
    float x, y, z;
};
// As in common.glsl.
inline constexpr LightWay kKeyLight = {-0.424F, 0.636F, 0.645F};
inline constexpr LightWay kFillLight = {0.802F, 0.134F, 0.582F};
inline constexpr LightWay kBackLight = {0.258F, 0.602F, -0.756F};

} // namespace frostfill::lanes
