// SPDX-License-Identifier: MIT
#include "render/raster/surface_tiles.hpp"

#include "render/picture/for_all.hpp"
#include "render/picture/painter_settings.hpp"
#include "render/picture/sphere_draw_list.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/spheres/resting_tile.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

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

std::vector<SphereInstance> placeSpheres(const Snapshot& snapshot, const Framing& framing)
{
    const Eigen::Vector3f offset =
        ((snapshot.origin - framing.centre) * framing.scale).cast<float>();
    const auto scale = static_cast<float>(framing.scale);
    std::vector<SphereInstance> spheres;
    spheres.reserve(snapshot.centres.size());
    for (std::size_t i = 0; i < snapshot.centres.size(); ++i)
    {
        const Eigen::Vector3f centre = snapshot.centres[i] * scale + offset;
        spheres.push_back({centre.x(),
                           centre.y(),
                           centre.z(),
                           snapshot.waits(i) ? 0 : snapshot.radii[i] * scale,
                           static_cast<std::uint32_t>(snapshot.states[i]),
                           {}});
        for (std::size_t c = 0; c < 4; ++c)
        {
            spheres.back().colour[c] = static_cast<std::uint8_t>((i + 1) >> (8 * c));
        }
    }
    return spheres;
}

void drawSurfaces(const Snapshot& snapshot, const Framing& framing, const RenderSettings& settings,
                  Surfaces& surfaces)
{
    const PictureSize& size = settings.size;
    const ShaderVariant variant{.orthographic = framing.orthographic,
                                .cutaway = settings.style.cutaway.kind != Cutaway::Kind::none};
    const TileView view{SphereRaster::ofSurfaces(uniformsOf(framing, settings), variant, size),
                        SphereProjector(framing, size)};
    const std::vector<SphereInstance> spheres = placeSpheres(snapshot, framing);
    const std::vector<std::uint32_t> order = nearestFirst(spheres, framing);
    std::vector<SphereInstance> sorted(spheres.size());
    std::vector<SphereBounds> placed(spheres.size());
    forAll(sorted.size(), kSpheresPerTask,
           [&](std::size_t i)
           {
               sorted[i] = spheres[order[i]];
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

void makePassPictures(const Surfaces& surfaces, const Framing& framing, PassPictures& pictures)
{
    constexpr double kFurthest = 65534;
    constexpr std::uint32_t kLargestIdentity = 0xffffff;
    const DepthLimits limits = depthLimits(framing.projection, framing.orthographic);
    pictures.nearest = limits.nearest / framing.scale;
    pictures.furthest = limits.furthest / framing.scale;
    const std::size_t count = surfaces.distance.size();
    pictures.depth.width = surfaces.width;
    pictures.depth.height = surfaces.height;
    pictures.depth.channels = 2;
    pictures.depth.pixels.resize(2 * count);
    for (Image* image : {&pictures.normal, &pictures.identity})
    {
        image->width = surfaces.width;
        image->height = surfaces.height;
        image->channels = 3;
        image->pixels.resize(3 * count);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        if (pictures.withIdentity && surfaces.identity[i] > kLargestIdentity)
        {
            throw Error(ErrorCode::usage,
                        fmt::format("the pass identity tells {} spheres apart, and sphere {} is "
                                    "seen: omit identity from frames.passes",
                                    kLargestIdentity, surfaces.identity[i] - 1));
        }
        const bool seen = surfaces.distance[i] != Surfaces::kNothing;
        const double share =
            (double{surfaces.distance[i]} - limits.nearest) / (limits.furthest - limits.nearest);
        const long depth = seen ? std::lround(kFurthest * std::clamp(share, 0.0, 1.0)) : 65535;
        pictures.depth.pixels[2 * i] = static_cast<std::uint8_t>(depth >> 8);
        pictures.depth.pixels[2 * i + 1] = static_cast<std::uint8_t>(depth & 255);
        for (std::size_t c = 0; c < 3; ++c)
        {
            pictures.normal.pixels[3 * i + c] = seen ? surfaces.normal[i][c] : std::uint8_t{128};
            pictures.identity.pixels[3 * i + c] =
                static_cast<std::uint8_t>(surfaces.identity[i] >> (8 * c));
        }
    }
}

} // namespace frostfill
