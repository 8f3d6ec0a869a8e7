// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/surfaces.hpp"

#include <frostfill/image.hpp>

namespace frostfill
{

/// Share of the light from all around that reaches each pixel, 0..1, top row first: 1 where nothing
/// is. Neighbours up to `reach` [unit space] away keep light off. After [McGuire et al. 2011], with
/// a fixed pattern of samples, so that equal surfaces give equal bytes.
[[nodiscard]] std::vector<float> ambientLight(const Surfaces& surfaces, const Framing& framing,
                                              double reach);

/// Darkens a picture of the same size, RGB or RGBA.
void applyAmbientLight(const std::vector<float>& light, Image& image);

} // namespace frostfill
