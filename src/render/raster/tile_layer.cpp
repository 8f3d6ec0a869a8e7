// SPDX-License-Identifier: MIT
#include "render/raster/tile_layer.hpp"

#include "render/framing/numbers.hpp"
#include "render/picture/for_all.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <atomic>
#include <cmath>
#include <utility>

namespace frostfill
{
namespace
{

/// Draws the shadow on the ground as ground.vert and ground.frag do: over the background, whatever
/// its depth, once for all samples of a pixel.
class GroundRaster
{
public:
    /// `ground` has a shadow, and must stay.
    GroundRaster(const GroundShadow& ground, const Viewpoint& viewpoint);

    /// Draws a whole tile. Returns whether any shadow is seen in it.
    bool draw(const TilePart& whole, TileBackground& pixels) const;

private:
    /// At a place of the picture [pixel]; 0 where the ground is not seen.
    [[nodiscard]] float darknessAt(float x, float y) const;
    [[nodiscard]] std::uint32_t blended(float dark) const;

    const GroundShadow& ground_;
    PixelGrid grid_;
    glm::vec4 background_; ///< premultiplied [0..1]
    // In eye space: a corner of the ground, its normal, and what gives a place on it in cells.
    glm::vec3 corner_, normal_, perAcross_, perAlong_;
};

GroundRaster::GroundRaster(const GroundShadow& ground, const Viewpoint& viewpoint)
    : ground_(ground),
      grid_(pixelGrid(viewpoint.uniforms().projection, viewpoint.framing().orthographic,
                      viewpoint.settings().size)),
      background_(toVector(viewpoint.settings().style.palette.background))
{
    const auto place = [&](int index)
    {
        return glm::vec3(viewpoint.uniforms().view *
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

/// Tiles whose samples are kept from picture to picture, of 32 KiB each: those of a picture of
/// 1920x1080. Fewer: others are drawn again wherever something moves over them.
constexpr int kMostKept = 2048;

} // namespace

TileLayer::TileLayer(const TileGrid& grid, const Viewpoint& viewpoint, int samples,
                     SphereOcclusion* occlusion)
    : grid_(grid), viewpoint_(viewpoint), sphereOcclusion_(occlusion), repainted_(grid.count())
{
    tiles_.reserve(grid_.count());
    for (std::size_t i = 0; i < grid_.count(); ++i)
    {
        tiles_.emplace_back(viewpoint.settings().style.palette.background, samples);
    }
}

void TileLayer::lookFrom(const TileView& view)
{
    view_ = &view;
    const std::optional<Studio>& studio = viewpoint_.studio();
    if (!studio)
    {
        return;
    }
    std::optional<GroundRaster> ground;
    if (studio->showsGround(viewpoint_.framing()))
    {
        ground.emplace(*studio->ground, viewpoint_);
    }
    tbb::parallel_for(std::size_t{0}, tiles_.size(),
                      [&](std::size_t tile)
                      {
                          auto pixels = ground ? std::make_unique<TileBackground>() : nullptr;
                          const bool seen = ground && ground->draw(grid_.part(tile), *pixels);
                          tiles_[tile].setGround(seen ? std::move(pixels) : nullptr);
                      });
}

void TileLayer::follow(std::span<const SphereInstance> resting, std::span<const SphereCell> cells)
{
    resting_ = resting;
    cells_ = cells;
}

RestingSpheres TileLayer::restingSpheres() const
{
    return {resting_,
            placed_,
            sphereOcclusion_ != nullptr ? sphereOcclusion_->lights() : LightsOfSpheres(),
            cells_,
            placedCells_,
            view_};
}

void TileLayer::listCells()
{
    placedCells_.resize(cells_.size());
    forAll(cells_.size(), kSpheresPerTask,
           [&](std::size_t i) { placedCells_[i] = view_->place(cells_[i].around); });
    std::vector<std::pair<float, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < cells_.size(); ++i)
    {
        if (!placedCells_[i].pixels.empty())
        {
            order.emplace_back(-placedCells_[i].nearest, i);
        }
    }
    tbb::parallel_sort(order.begin(), order.end());
    for (const auto& [nearest, cell] : order)
    {
        grid_.each(placedCells_[cell].pixels,
                   [&, cell = cell](std::size_t tile) { tiles_[tile].listCell(cell); });
    }
}

void TileLayer::rebuild(bool cull, std::span<PixelRectangle> dirty)
{
    for (RestingTile& tile : tiles_)
    {
        tile.clear();
    }
    listCells();
    const std::size_t inCells = restingSpheres().inCells();
    placed_.resize(resting_.size() - inCells);
    forAll(placed_.size(), kSpheresPerTask,
           [&](std::size_t i) { placed_[i] = view_->place(resting_[inCells + i]); });
    for (std::size_t i = 0; i < placed_.size(); ++i)
    {
        const auto sphere = static_cast<std::uint32_t>(inCells + i);
        grid_.each(placed_[i].pixels,
                   [&](std::size_t tile) { tiles_[tile].list(sphere, placed_[i].nearest); });
    }
    if (sphereOcclusion_ != nullptr)
    {
        if (cull || !cells_.empty())
        {
            // Only their shapes, to see which spheres need light.
            RestingSpheres shapes = restingSpheres();
            shapes.lights = {};
            repaintTiles(shapes, cull);
        }
        updateVisibleLight();
    }
    repaintTiles(restingSpheres(), cull);
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    {
        dirty[tile] = grid_.part(tile).pixels;
    }
}

void TileLayer::repaintTiles(const RestingSpheres& resting, bool cull)
{
    std::atomic<int> kept = 0;
    tbb::parallel_for(std::size_t{0}, tiles_.size(),
                      [&](std::size_t tile)
                      {
                          RestingTile& own = tiles_[tile];
                          own.repaint(view_->raster, resting, grid_.part(tile), cull);
                          if (own.samples() != nullptr && ++kept > kMostKept)
                          {
                              own.forgetSamples();
                          }
                      });
}

void TileLayer::repaint(std::span<const std::size_t> recoloured, std::span<PixelRectangle> dirty)
{
    // Many change at once where groups are discarded, and a tile takes as long for all as for one.
    std::vector<std::size_t> stale;
    const auto note = [&](std::uint32_t sphere)
    {
        const PixelRectangle pixels = boundsOf(sphere).pixels;
        grid_.each(pixels,
                   [&](std::size_t tile)
                   {
                       if (isSeen(sphere, tile))
                       {
                           if (repainted_[tile].empty())
                           {
                               stale.push_back(tile);
                           }
                           repainted_[tile] =
                               around(repainted_[tile], grid_.part(tile).within(pixels));
                       }
                   });
    };
    for (const std::size_t sphere : recoloured)
    {
        note(static_cast<std::uint32_t>(sphere));
    }
    if (sphereOcclusion_ != nullptr)
    {
        const auto isSeenAnywhere = [&](std::uint32_t sphere)
        {
            bool seen = false;
            grid_.each(boundsOf(sphere).pixels,
                       [&](std::size_t tile) { seen = seen || isSeen(sphere, tile); });
            return seen;
        };
        for (const std::uint32_t sphere : sphereOcclusion_->refresh(isSeenAnywhere))
        {
            note(sphere);
        }
    }
    for (const std::size_t tile : stale)
    {
        tiles_[tile].recolour(view_->raster, restingSpheres(), grid_.part(tile), repainted_[tile]);
        dirty[tile] = around(dirty[tile], repainted_[tile]);
        repainted_[tile] = {};
    }
}

void TileLayer::add(std::size_t first, std::span<PixelRectangle> dirty)
{
    for (std::size_t i = first; i < resting_.size(); ++i)
    {
        placed_.push_back(view_->place(resting_[i]));
        const SphereBounds& placed = placed_.back();
        if (sphereOcclusion_ != nullptr && !isHidden(placed))
        {
            sphereOcclusion_->ofResting(i);
        }
        const RestingSpheres resting = restingSpheres();
        grid_.each(
            placed.pixels,
            [&](std::size_t tile)
            {
                const TilePart whole = grid_.part(tile);
                if (tiles_[tile].add(view_->raster, resting, static_cast<std::uint32_t>(i), whole))
                {
                    dirty[tile] = around(dirty[tile], whole.within(placed.pixels));
                }
            });
    }
}

std::optional<SphereLight> TileLayer::lightOn(const SphereInstance& sphere,
                                              const SphereBounds& placed)
{
    if (sphereOcclusion_ == nullptr)
    {
        return {};
    }
    return isHidden(placed) ? SphereLight{} : sphereOcclusion_->of(sphere);
}

void TileLayer::updateVisibleLight()
{
    std::vector<bool> seen(resting_.size());
    for (const RestingTile& tile : tiles_)
    {
        tile.each([&](std::uint32_t sphere) { seen[sphere] = true; });
    }
    std::vector<std::uint32_t> spheres;
    for (std::uint32_t i = 0; i < seen.size(); ++i)
    {
        if (seen[i])
        {
            spheres.push_back(i);
        }
    }
    sphereOcclusion_->ask(spheres);
}

bool TileLayer::isSeen(std::uint32_t resting, std::size_t tile) const
{
    return tiles_[tile].lists(resting) && !hides(boundsOf(resting), tile);
}

bool TileLayer::isHidden(const SphereBounds& sphere) const
{
    bool hidden = true;
    grid_.each(sphere.pixels, [&](std::size_t tile) { hidden = hidden && hides(sphere, tile); });
    return hidden;
}

} // namespace frostfill
