// SPDX-License-Identifier: MIT
#include "render/raster/spheres/ground_raster.hpp"

#include "render/framing/numbers.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
GroundRaster::GroundRaster(const GroundShadow& ground, const glm::mat4& view, const PixelGrid& grid,
                           const Colour& background)
    : ground_(ground), grid_(grid), background_(toVector(background))
{
    const auto place = [&](int index)
    {
        return glm::vec3(view *
                         glm::vec4(glm::vec3(ground.places[static_cast<std::size_t>(index)]), 1));
    };
    corner_ = place(0);
    const glm::vec3 across = place(1) - corner_;
    const glm::vec3 along = place(ground.cells + 1) - corner_;
    normal_ = glm::cross(across, along);
    perAcross_ = glm::cross(along, normal_) / glm::dot(across, glm::cross(along, normal_));
    perAlong_ = glm::cross(normal_, across) / glm::dot(along, glm::cross(normal_, across));
    background_ *= glm::vec4(glm::vec3(background_.a), 1);
}

float GroundRaster::darknessAt(float x, float y) const
{
    const glm::vec2 seen(grid_.left + grid_.perColumn * x, grid_.bottom + grid_.perRow * y);
    const glm::vec3 from = grid_.orthographic ? glm::vec3(seen, 0) : glm::vec3(0);
    const glm::vec3 ray = grid_.orthographic ? glm::vec3(0, 0, -1) : glm::vec3(seen, -1);
    const float way = glm::dot(corner_ - from, normal_) / glm::dot(ray, normal_);
    if (!grid_.orthographic && !(way > 0))
    {
        return 0;
    }
    const glm::vec3 onGround = from + way * ray - corner_;
    const glm::vec2 place(glm::dot(onGround, perAcross_), glm::dot(onGround, perAlong_));
    const auto cells = static_cast<float>(ground_.cells);
    if (!(place.x >= 0 && place.y >= 0 && place.x < cells && place.y < cells))
    {
        return 0;
    }
    // Two triangles, on either side of the diagonal from the cell's first corner.
    const glm::vec2 cell = glm::floor(place);
    const glm::vec2 in = place - cell;
    const auto at = [&](int right, int up)
    {
        const int index = (static_cast<int>(cell.y) + up) * (ground_.cells + 1) +
                          static_cast<int>(cell.x) + right;
        return ground_.places[static_cast<std::size_t>(index)].w;
    };
    const float near = at(0, 0);
    const float far = at(1, 1);
    return in.x > in.y ? near + in.x * (at(1, 0) - near) + in.y * (far - at(1, 0))
                       : near + in.y * (at(0, 1) - near) + in.x * (far - at(0, 1));
}

std::uint32_t GroundRaster::blended(float dark) const
{
    const glm::vec4 colour = dark * glm::vec4(shading::kShadow, 1) + (1 - dark) * background_;
    std::uint32_t word = 0;
    for (int c = 0; c < 4; ++c)
    {
        const auto byte = std::lround(255 * glm::clamp(colour[c], 0.0F, 1.0F));
        word |= static_cast<std::uint32_t>(byte) << (8 * c);
    }
    return word;
}

bool GroundRaster::draw(const TilePart& whole, TileBackground& pixels) const
{
    bool seen = false;
    for (int y = 0; y < kTileEdge; ++y)
    {
        for (int x = 0; x < kTileEdge; ++x)
        {
            const float dark = darknessAt(static_cast<float>(whole.left + x) + 0.5F,
                                          static_cast<float>(whole.bottom + y) + 0.5F);
            seen = seen || dark > 0;
            const int at = y * kTileEdge + x;
            pixels[static_cast<std::size_t>(at)] = blended(dark);
        }
    }
    return seen;
}

} // namespace frostfill
