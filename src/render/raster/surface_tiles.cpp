// SPDX-License-Identifier: MIT
#include "render/raster/surface_tiles.hpp"

#include "render/picture/for_all.hpp"
#include "render/picture/sphere_draw_list.hpp"
#include "render/raster/lanes/tile_grid.hpp"
#include "render/raster/spheres/resting_tile.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// Nearest first, and each with its identity for a colour: the index + 1.
std::vector<SphereInstance> withIdentities(std::span<const SphereInstance> spheres,
                                           const Framing& framing)
{
    const std::vector<std::uint32_t> order = nearestFirst(spheres, framing);
    std::vector<SphereInstance> result(spheres.size());
    forAll(order.size(), kSpheresPerTask,
           [&](std::size_t i)
           {
               result[i] = spheres[order[i]];
               for (std::size_t c = 0; c < 4; ++c)
               {
                   result[i].colour[c] = static_cast<std::uint8_t>((order[i] + 1) >> (8 * c));
               }
           });
    return result;
}

/// Of a tile, top row first; `inPicture` is the part of it that is. What bulges out nearer than
/// `nearest`, where the picture begins, is as far as that, as OpenGL has it.
void write(const SampleTile* tile, const PixelRectangle& inPicture, const TilePart& part,
           bool orthographic, float nearest, Surfaces& surfaces)
{
    for (int y = inPicture.bottom; y < inPicture.top; ++y)
    {
        for (int x = inPicture.left; x < inPicture.right; ++x)
        {
            const auto to = static_cast<std::size_t>(surfaces.height - 1 - y) *
                                static_cast<std::size_t>(surfaces.width) +
                            static_cast<std::size_t>(x);
            const int pixel = (y - part.bottom) * kTileEdge + x - part.left;
            const auto at = static_cast<std::size_t>(pixel);
            const float near = tile != nullptr ? tile->inverseDepth[0][at] : kNothing;
            if (near == kNothing)
            {
                surfaces.distance[to] = Surfaces::kNothing;
                surfaces.normal[to] = {};
                surfaces.identity[to] = 0;
                continue;
            }
            surfaces.distance[to] = std::max(orthographic ? -near : 1 / near, nearest);
            const std::uint32_t normal = tile->colour[0][at];
            surfaces.normal[to] = {static_cast<std::uint8_t>(normal),
                                   static_cast<std::uint8_t>(normal >> 8),
                                   static_cast<std::uint8_t>(normal >> 16)};
            surfaces.identity[to] = tile->colour[SphereRaster::kIdentities][at];
        }
    }
}

} // namespace

void drawSurfacesInTiles(std::span<const SphereInstance> spheres, const TileView& view,
                         const Framing& framing, const PictureSize& size, Surfaces& surfaces)
{
    const std::vector<SphereInstance> sorted = withIdentities(spheres, framing);
    std::vector<SphereBounds> placed(sorted.size());
    forAll(sorted.size(), kSpheresPerTask,
           [&](std::size_t i)
           {
               if (sorted[i].radius > 0) // it waits for its fall else
               {
                   placed[i] = view.place(sorted[i]);
               }
           });
    const TileGrid grid(size);
    TileLists lists(grid);
    for (std::uint32_t i = 0; i < sorted.size(); ++i)
    {
        lists.list(i, placed[i].pixels);
    }
    const auto nearest =
        static_cast<float>(depthLimits(framing.projection, framing.orthographic).nearest);
    surfaces.width = size.width;
    surfaces.height = size.height;
    const auto pixels =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    surfaces.distance.resize(pixels);
    surfaces.normal.resize(pixels);
    surfaces.identity.resize(pixels);
    tbb::parallel_for(std::size_t{0}, grid.count(),
                      [&](std::size_t t)
                      {
                          const TilePart part = grid.part(t);
                          RestingTile tile({}, 1);
                          for (const std::uint32_t sphere : lists[t])
                          {
                              tile.list(sphere, placed[sphere].nearest);
                          }
                          tile.repaint(view.raster, {sorted, placed, {}}, part, true);
                          write(tile.samples(), grid.inPicture(part), part, framing.orthographic,
                                nearest, surfaces);
                      });
}

} // namespace frostfill
