// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/snapshot.hpp>

#include <glm/vec3.hpp>

#include <cstdint>

/// The text of the shaders that has numbers, as C++.
namespace frostfill::shading
{

using glm::vec3;
using uint = std::uint32_t;

#include "../../../shaders/numbers.glsl"

static_assert(kRunning == static_cast<uint>(SphereState::running));
static_assert(kFrozen == static_cast<uint>(SphereState::frozen));
static_assert(kDiscarded == static_cast<uint>(SphereState::discarded));
static_assert(kDiscardedPolygon == static_cast<uint>(PolygonState::discarded));

} // namespace frostfill::shading
