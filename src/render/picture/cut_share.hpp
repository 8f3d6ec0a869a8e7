// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/sphere_instance.hpp"

#include <cstdint>

namespace frostfill
{

/// What a cutaway leaves of a sphere. Most are whole or gone: those are drawn, or not, as without
/// one, at a quarter of the cost.
enum class CutShare : std::uint8_t
{
    whole,
    part,
    nothing,
};

/// By the planes of the uniforms.
[[nodiscard]] CutShare cutShareOf(const SphereInstance& sphere, const SphereUniforms& uniforms);

} // namespace frostfill
