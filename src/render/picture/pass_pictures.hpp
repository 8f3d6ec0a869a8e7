// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/surfaces.hpp"

#include <frostfill/renderer.hpp>

namespace frostfill
{

/// Surfaces in the form in which they are given out. `pictures` is reused.
void makePassPictures(const Surfaces& surfaces, const Framing& framing, PassPictures& pictures);

} // namespace frostfill
