// SPDX-License-Identifier: MIT
#include "render/raster/tile_pipeline.hpp"

#include "render/picture/for_all.hpp"
#include "render/picture/painter_settings.hpp"
#include "render/picture/sphere_draw_list.hpp"
#include "render/raster/lanes/sample_tile.hpp"
#include "render/raster/spheres/resting_tile.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

/// Of a tile; `inPicture` is the part of it that is. What bulges out nearer than `nearest`, where
/// the picture begins, is as far as that, as OpenGL has it.
void write(const SampleTile* tile, const PixelRectangle& inPicture, const TilePart& part,
           bool orthographic, float nearest, Surfaces& surfaces)
{
    for (int y = inPicture.bottom; y < inPicture.top; ++y)
    {
        for (int x = inPicture.left; x < inPicture.right; ++x)
        {
            const int pixel = (y - part.bottom) * kTileEdge + x - part.left;
            const auto at = static_cast<std::size_t>(pixel);
            const float near = tile != nullptr ? tile->inverseDepth[0][at] : kNothing;
            if (near == kNothing)
            {
                surfaces.set(x, y, Surfaces::kNothing, 0, 0);
                continue;
            }
            surfaces.set(x, y, std::max(orthographic ? -near : 1 / near, nearest),
                         tile->colour[0][at], tile->colour[SphereRaster::kIdentities][at]);
        }
    }
}

/// Draws spheres for what they are and not how they look, as SurfacePass does. The view's raster is
/// one of surfaces.
void drawSurfacesInTiles(std::span<const SphereInstance> spheres, const TileView& view,
                         const Framing& framing, const PictureSize& size, Surfaces& surfaces)
{
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
    TileLists lists(grid.count());
    for (std::uint32_t i = 0; i < sorted.size(); ++i)
    {
        grid.list(i, placed[i].pixels, lists);
    }
    const auto nearest =
        static_cast<float>(depthLimits(framing.projection, framing.orthographic).nearest);
    surfaces.resize(size);
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

} // namespace

TilePipeline::TilePipeline(const TriangleMesh& mesh, const RenderSettings& settings)
    : PictureBackend(mesh, settings), strokes_(strokesFor(settings, mesh.triangles.size())),
      samples_(settings.samples > 1 ? kMaxTileSamples : 1), grid_(settings.size),
      layer_(grid_, viewpoint(), samples_, sphereOcclusion())
{
    runningIn_.resize(grid_.count());
    dirty_.resize(grid_.count());
    useShell();
    useFraming();
}

void TilePipeline::useShell()
{
    if (!viewpoint().settings().style.shell)
    {
        return;
    }
    shell_ = std::make_unique<ShellRaster>(shell().shaded(), viewpoint().variant(),
                                           shellPalette(viewpoint().settings().style), strokes_,
                                           samples_);
    if (viewpoint().settings().staticLayer)
    {
        keptShell_ = std::make_unique<KeptShell>(*shell_, grid_.count());
    }
}

void TilePipeline::useFraming()
{
    const RenderSettings& settings = viewpoint().settings();
    const SphereUniforms& uniforms = viewpoint().uniforms();
    view_.emplace(TileView{SphereRaster(uniforms, viewpoint().variant(), settings.size,
                                        settings.style, strokes_.lineWidth, samples_),
                           SphereProjector(framing(), settings.size)});
    layer_.lookFrom(*view_);
    if (shell_)
    {
        shell_->lookFrom(uniforms, framing().orthographic, settings.size, shell().edges());
        triangles_.assign(grid_.count(), {});
        for (const std::uint32_t triangle : shell_->inDrawingOrder())
        {
            grid_.list(triangle, shell_->bounds(triangle), triangles_);
        }
        if (keptShell_)
        {
            keptShell_->forget();
        }
    }
}

void TilePipeline::drawSurfaces(const Snapshot& snapshot, const PictureSize& size,
                                Surfaces& surfaces)
{
    follow(snapshot);
    const TileView view{
        SphereRaster::ofSurfaces(viewpoint().uniforms(), viewpoint().variant(), size),
        SphereProjector(framing(), size)};
    drawSurfacesInTiles(placeSpheres(snapshot, framing()), view, framing(), size, surfaces);
}

const std::string& TilePipeline::description() const
{
    static const std::string text = "builtin: spheres and shell on the processor";
    return text;
}

void TilePipeline::renew(std::size_t tile, const PixelRectangle& pixels)
{
    dirty_[tile] = around(dirty_[tile], grid_.part(tile).within(pixels));
}

const std::vector<PixelRectangle>& TilePipeline::draw(const Snapshot& snapshot, Image& image)
{
    const RenderSettings& settings = viewpoint().settings();
    const Changes changes = take(snapshot, true);
    if (shell_)
    {
        if (!changes.triangles.empty())
        {
            shell_->setStates(shell().states());
        }
        for (const std::uint32_t triangle : changes.triangles)
        {
            const PixelRectangle pixels = shell_->bounds(triangle);
            grid_.each(pixels,
                       [&](std::size_t tile)
                       {
                           renew(tile, pixels);
                           if (keptShell_)
                           {
                               keptShell_->forget(tile);
                           }
                       });
        }
    }
    layer_.follow(spheres().resting(), spheres().cells());
    if (changes.startAgain || !settings.staticLayer)
    {
        layer_.rebuild(settings.staticLayer, dirty_);
    }
    else
    {
        layer_.repaint(changes.spheres.recoloured, dirty_);
        layer_.add(changes.spheres.firstArrival, dirty_);
    }
    placeRunning();

    image.width = settings.size.width;
    image.height = settings.size.height;
    image.channels = settings.style.palette.background[3] < 255 ? 4 : 3;
    image.pixels.resize(static_cast<std::size_t>(image.width * image.height) *
                        static_cast<std::size_t>(image.channels));
    composeDirty(changes.startAgain, image);
    return parts_;
}

void TilePipeline::placeRunning()
{
    for (const SphereBounds& before : running_)
    {
        grid_.each(before.pixels,
                   [&](std::size_t tile)
                   {
                       if (!runningIn_[tile].empty()) // it was seen here
                       {
                           renew(tile, before.pixels);
                       }
                   });
    }
    for (const SphereBounds& before : running_)
    {
        grid_.each(before.pixels, [&](std::size_t tile) { runningIn_[tile].clear(); });
    }
    running_.clear();
    runningLights_.clear();
    for (const SphereInstance& sphere : spheres().running())
    {
        const auto index = static_cast<std::uint32_t>(running_.size());
        const SphereBounds now = view_->place(sphere);
        running_.push_back(now);
        runningLights_.push_back(layer_.lightOn(sphere, now));
        grid_.each(now.pixels,
                   [&](std::size_t tile)
                   {
                       if (!layer_.hides(now, tile))
                       {
                           runningIn_[tile].push_back(index);
                           renew(tile, now.pixels);
                       }
                   });
    }
}

void TilePipeline::composeDirty(bool manyTiles, Image& image)
{
    std::vector<std::size_t> dirty;
    for (std::size_t tile = 0; tile < dirty_.size(); ++tile)
    {
        if (!dirty_[tile].empty())
        {
            dirty.push_back(tile);
        }
    }
    parts_.resize(dirty.size());
    const auto composeOne = [&](std::size_t i)
    { parts_[i] = compose(dirty[i], work_.local(), image); };
    if (manyTiles)
    {
        tbb::parallel_for(std::size_t{0}, dirty.size(), composeOne);
    }
    else
    {
        for (std::size_t i = 0; i < dirty.size(); ++i)
        {
            composeOne(i);
        }
    }
    std::erase_if(parts_, [](const PixelRectangle& part) { return part.empty(); });
}

PixelRectangle TilePipeline::compose(std::size_t tile, SampleTile& work, Image& image)
{
    TilePart dirty = grid_.part(tile);
    dirty.pixels = std::exchange(dirty_[tile], {});
    const RestingTile& resting = layer_[tile];
    layer_.copyTo(tile, dirty, work);
    for (const std::uint32_t sphere : runningIn_[tile])
    {
        const auto& light = runningLights_[sphere];
        view_->raster.draw(spheres().running()[sphere], running_[sphere].pixels, dirty, work,
                           light ? &*light : nullptr);
    }
    if (shell_)
    {
        const auto& triangles = triangles_[tile];
        keptShell_ ? keptShell_->draw(tile, triangles, dirty, work, resting)
                   : shell_->draw(triangles, dirty, work);
    }
    const PixelRectangle inPicture = grid_.inPicture(dirty);
    if (!inPicture.empty())
    {
        resolve(work, dirty, samples_, image);
    }
    return inPicture;
}

} // namespace frostfill
