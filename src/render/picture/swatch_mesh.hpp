// SPDX-License-Identifier: MIT
#pragma once

#include "render/overlay/colour_scale.hpp"
#include "render/overlay/legend.hpp"
#include "render/picture/mesh_shading.hpp"
#include "render/picture/sphere_instance.hpp"

#include <frostfill/snapshot.hpp>
#include <frostfill/view.hpp>

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// The legend's swatches, for the programs that draw the scene. They are seen face on and without
/// perspective. [pixel], y upwards from the lower edge of the picture
struct SwatchShapes
{
    std::vector<SphereInstance> spheres;
    ShadedMesh polygons;                                ///< a square each, as two triangles
    std::vector<std::array<std::uint8_t, 3>> strengths; ///< [#T] of their edges, but no diagonals
    std::vector<PolygonState> states;                   ///< [#T]
};

/// `height` is that of the picture [pixel].
[[nodiscard]] SwatchShapes swatchShapes(const Legend& legend, const SphereColours& colours,
                                        int height);

/// From pixels, y upwards, to clip space. Swatches lie at the very front of the depth range.
[[nodiscard]] glm::mat4 pixelProjection(const PictureSize& size);

} // namespace frostfill
