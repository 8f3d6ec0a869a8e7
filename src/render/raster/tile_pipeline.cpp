// SPDX-License-Identifier: MIT
#include "render/raster/tile_pipeline.hpp"

#include "render/layer/painter_settings.hpp"
#include "render/raster/resolve.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// Longest edge of a picture, as OpenGL has it here.
constexpr int kLongestEdge = 16384;
/// That one core places before another may take more. More: cores wait for each other at the end.
/// Fewer: handing them out costs more.
constexpr std::size_t kSpheresATask = 4096;

} // namespace

bool TilePipeline::draws(const RenderSettings& settings)
{
    const Style& style = settings.style;
    return (style.look == Look::clean || style.look == Look::dark) &&
           style.cutaway.kind == Cutaway::Kind::none && !style.ambientOcclusion;
}

TilePipeline::TilePipeline(const TriangleMesh& mesh, const RenderSettings& settings)
    : viewpoint_(mesh, settings), size_(settings.size),
      samples_(settings.samples > 1 ? kMostTileSamples : 1), grid_(size_)
{
    if (size_.width > kLongestEdge || size_.height > kLongestEdge)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("a picture of {}x{} pixels cannot be drawn: each edge must be "
                                "between 1 and {} pixels",
                                size_.width, size_.height, kLongestEdge));
    }
    tiles_.reserve(grid_.count());
    for (std::size_t i = 0; i < grid_.count(); ++i)
    {
        tiles_.push_back({RestingTile(settings.style.palette.background, samples_), {}, {}, {}});
    }
    if (settings.style.shell)
    {
        addShell(mesh);
    }
    if (viewpoint_.legend().visible())
    {
        swatches_ = std::make_unique<SwatchRaster>(viewpoint_, samples_);
    }
    useFraming();
}

void TilePipeline::addShell(const TriangleMesh& mesh)
{
    std::vector<glm::vec3> positions;
    positions.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(viewpoint_.framing().toUnit(vertex));
    }
    shaded_ = shadeMesh(mesh, positions, true);
    shell_ = std::make_unique<ShellRaster>(shaded_, shellPalette(viewpoint_.settings().style),
                                           strokesFor(viewpoint_.settings()), samples_);
}

void TilePipeline::lookFrom(const Camera& camera)
{
    viewpoint_.lookFrom(camera);
    useFraming();
}

void TilePipeline::turn(double degrees)
{
    if (viewpoint_.turn(degrees))
    {
        useFraming();
    }
}

void TilePipeline::useFraming()
{
    const Framing& framing = viewpoint_.framing();
    const Style& style = viewpoint_.settings().style;
    const SphereUniforms uniforms = uniformsOf(framing, size_, style.look);
    raster_.emplace(uniforms, framing.orthographic, size_, style.palette.background, samples_);
    projector_.emplace(framing, size_);
    if (shell_)
    {
        shell_->lookFrom(uniforms, framing.orthographic, size_,
                         edgeStrengths(shaded_, glm::vec3(framing.eye), framing.orthographic));
        triangles_.emplace(shaded_, framing, size_);
    }
    stale_ = true;
}

void TilePipeline::markDirty(const PixelRectangle& pixels)
{
    grid_.each(pixels,
               [&](std::size_t tile) {
                   tiles_[tile].dirty = around(tiles_[tile].dirty, grid_.part(tile).within(pixels));
               });
}

SphereBounds TilePipeline::place(const SphereInstance& sphere) const
{
    return {projector_->project(sphere).pixels, raster_->nearest(sphere)};
}

const std::vector<PixelRectangle>& TilePipeline::draw(const Snapshot& snapshot, Image& image)
{
    if (viewpoint_.follow(snapshot))
    {
        useFraming();
    }
    const bool layer = viewpoint_.settings().staticLayer;
    const SphereLedger::Changes& changes =
        ledger_.update(snapshot, viewpoint_.framing(), viewpoint_.colours());
    const bool startAgain = stale_ || changes.everything;
    if (startAgain && ledger_.resting().size() >= kSortFrom)
    {
        ledger_.sortFrontToBack(viewpoint_.framing());
    }
    if (shell_)
    {
        for (const std::uint32_t triangle : shell_->setStates(snapshot.polygons))
        {
            markDirty(shell_->bounds(triangle));
        }
    }
    stale_ = false;
    if (startAgain || !layer)
    {
        rebuild();
    }
    else
    {
        repaintResting(changes.recoloured);
        addArrivals(changes.firstArrival);
    }
    placeRunning();

    image.width = size_.width;
    image.height = size_.height;
    image.channels = viewpoint_.settings().style.palette.background[3] < 255 ? 4 : 3;
    image.pixels.resize(static_cast<std::size_t>(image.width * image.height) *
                        static_cast<std::size_t>(image.channels));
    composeDirty(startAgain, image);
    return parts_;
}

void TilePipeline::rebuild()
{
    const bool cull = viewpoint_.settings().staticLayer;
    const auto resting = ledger_.resting();
    for (Tile& tile : tiles_)
    {
        tile.resting.clear();
    }
    placed_.resize(resting.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, resting.size(), kSpheresATask),
                      [&](const auto& range)
                      {
                          for (std::size_t i = range.begin(); i < range.end(); ++i)
                          {
                              placed_[i] = place(resting[i]);
                          }
                      });
    for (std::uint32_t i = 0; i < resting.size(); ++i)
    {
        const SphereBounds& placed = placed_[i];
        grid_.each(placed.pixels,
                   [&](std::size_t tile) { tiles_[tile].resting.list(i, placed.nearest); });
    }
    tbb::parallel_for(std::size_t{0}, tiles_.size(),
                      [&](std::size_t tile)
                      {
                          const TilePart whole = grid_.part(tile);
                          tiles_[tile].resting.repaint(*raster_, resting, placed_, whole, cull);
                          tiles_[tile].dirty = whole.pixels;
                      });
}

void TilePipeline::repaintResting(std::span<const std::size_t> recoloured)
{
    // Many change at once where groups are discarded, and a tile takes as long for all as for one.
    std::vector<std::size_t> stale;
    for (const std::size_t sphere : recoloured)
    {
        grid_.each(placed_[sphere].pixels,
                   [&](std::size_t tile)
                   {
                       Tile& own = tiles_[tile];
                       const TilePart whole = grid_.part(tile);
                       if (own.resting.lists(static_cast<std::uint32_t>(sphere)) &&
                           !own.resting.hides(placed_[sphere], whole))
                       {
                           if (own.recoloured.empty())
                           {
                               stale.push_back(tile);
                           }
                           own.recoloured =
                               around(own.recoloured, whole.within(placed_[sphere].pixels));
                       }
                   });
    }
    for (const std::size_t tile : stale)
    {
        Tile& own = tiles_[tile];
        own.resting.recolour(*raster_, ledger_.resting(), placed_, grid_.part(tile),
                             own.recoloured);
        own.dirty = around(own.dirty, own.recoloured);
        own.recoloured = {};
    }
}

void TilePipeline::addArrivals(std::size_t first)
{
    const auto resting = ledger_.resting();
    for (std::size_t i = first; i < resting.size(); ++i)
    {
        placed_.push_back(place(resting[i]));
        const SphereBounds& placed = placed_.back();
        grid_.each(placed.pixels,
                   [&](std::size_t tile)
                   {
                       const TilePart whole = grid_.part(tile);
                       if (tiles_[tile].resting.add(*raster_, resting[i], placed,
                                                    static_cast<std::uint32_t>(i), whole))
                       {
                           tiles_[tile].dirty =
                               around(tiles_[tile].dirty, whole.within(placed.pixels));
                       }
                   });
    }
}

void TilePipeline::placeRunning()
{
    for (const SphereBounds& before : running_)
    {
        grid_.each(before.pixels,
                   [&](std::size_t tile)
                   {
                       Tile& own = tiles_[tile];
                       if (!own.running.empty()) // it was seen here
                       {
                           own.dirty = around(own.dirty, grid_.part(tile).within(before.pixels));
                       }
                   });
    }
    for (const SphereBounds& before : running_)
    {
        grid_.each(before.pixels, [&](std::size_t tile) { tiles_[tile].running.clear(); });
    }
    running_.clear();
    for (const SphereInstance& sphere : ledger_.running())
    {
        const auto index = static_cast<std::uint32_t>(running_.size());
        running_.push_back(place(sphere));
        const SphereBounds& now = running_.back();
        grid_.each(now.pixels,
                   [&](std::size_t tile)
                   {
                       Tile& own = tiles_[tile];
                       const TilePart whole = grid_.part(tile);
                       if (!own.resting.hides(now, whole))
                       {
                           own.running.push_back(index);
                           own.dirty = around(own.dirty, whole.within(now.pixels));
                       }
                   });
    }
}

void TilePipeline::composeDirty(bool manyTiles, Image& image)
{
    std::vector<std::size_t> dirty;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    {
        if (!tiles_[tile].dirty.empty())
        {
            dirty.push_back(tile);
        }
    }
    parts_.resize(dirty.size());
    const auto composeOne = [&](std::size_t i)
    { parts_[i] = compose(dirty[i], work_.local(), image); };
    if (manyTiles)
    {
        if (shell_)
        {
            shell_->setUpAll();
        }
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
    Tile& own = tiles_[tile];
    TilePart dirty = grid_.part(tile);
    dirty.pixels = own.dirty;
    own.dirty = {};
    own.resting.copyTo(work, dirty.pixels);
    for (const std::uint32_t sphere : own.running)
    {
        raster_->draw(ledger_.running()[sphere], running_[sphere].pixels, dirty, work);
    }
    if (shell_)
    {
        shell_->draw(triangles_->inTile(grid_.column(tile), grid_.row(tile)), dirty, work,
                     viewpoint_.settings().staticLayer ? &own.resting : nullptr);
    }
    const PixelRectangle inPicture = grid_.inPicture(dirty);
    if (swatches_ && swatches_->pixels().overlaps(inPicture))
    {
        swatches_->draw(dirty, work);
    }
    if (!inPicture.empty())
    {
        resolve(work, dirty, samples_, image);
    }
    return inPicture;
}

} // namespace frostfill
