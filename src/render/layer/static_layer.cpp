// SPDX-License-Identifier: MIT
#include "render/layer/static_layer.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace frostfill
{

namespace
{

/// Spheres are drawn in batches, and what the earlier ones hide is left out of the later ones. To
/// look at the depths costs as much as to draw some hundred spheres.
constexpr std::size_t kFirstBatch = 400;
constexpr std::size_t kBatchShare = 24;

/// What came to rest since may hide others by now. To look for them takes as long as to draw all
/// that may be seen, so that is done when so many have come in addition.
constexpr std::size_t kFewArrivals = 200;

} // namespace

StaticLayer::StaticLayer(const GlFunctions& gl, const PictureSize& size, int samples,
                         bool paintsOccluders)
    : framebuffer_(gl, size.width, size.height, samples), occlusion_(size.width, size.height)
{
    if (framebuffer_.samples() > 1 && paintsOccluders)
    {
        occluders_.emplace(gl, size.width, size.height, 1);
    }
}

void StaticLayer::projectSpheres(const SphereProjector& projector,
                                 std::span<const SphereInstance> resting, std::size_t first,
                                 std::size_t end)
{
    spheres_.clear();
    parts_.clear();
    for (std::size_t i = first; i < end; ++i)
    {
        const ProjectedSphere sphere = projector.project(resting[i]);
        if (!hides(sphere))
        {
            drawn_ = around(drawn_, sphere.pixels);
            seen_.push_back({static_cast<std::uint32_t>(i), sphere.pixels});
            parts_.push_back({sphere.pixels, sphere.furthestDepth});
            spheres_.push_back(resting[i]);
        }
    }
}

void StaticLayer::findHidden(ScenePainter& painter, const SphereProjector& projector)
{
    if (framebuffer_.samples() == 1)
    {
        framebuffer_.readDepth(drawn_, depths_);
    }
    else if (!occluders_)
    {
        return; // depths of samples tell nothing of whole pixels
    }
    else
    {
        occluders_->bind();
        painter.paintOccluders(spheres_, projector);
        occluders_->readDepth(drawn_, depths_);
        framebuffer_.bind();
    }
    occlusion_.build(drawn_, depths_);
}

void StaticLayer::rebuild(ScenePainter& painter, const SphereProjector& projector,
                          std::span<const SphereInstance> resting)
{
    occlusion_.clear();
    seen_.clear();
    drawn_ = {};
    if (occluders_)
    {
        occluders_->bind();
        painter.clear();
    }
    framebuffer_.bind();
    painter.clear();
    painter.paintGround();
    std::size_t batch = std::max(kFirstBatch, resting.size() / kBatchShare);
    for (std::size_t first = 0; first < resting.size();)
    {
        const std::size_t end = std::min(first + batch, resting.size());
        projectSpheres(projector, resting, first, end);
        painter.paintSpheres(spheres_);
        first = end;
        batch += batch / 2;
        if (first < resting.size())
        {
            findHidden(painter, projector);
        }
    }
    seenAtLast_ = seen_.size();
    painter.paintShell();
}

PixelRectangle StaticLayer::add(ScenePainter& painter, const SphereProjector& projector,
                                std::span<const SphereInstance> resting, std::size_t first)
{
    projectSpheres(projector, resting, first, resting.size());
    framebuffer_.bind();
    painter.addSpheres(spheres_, parts_);
    PixelRectangle drawn;
    for (const PicturePart& part : parts_)
    {
        drawn = around(drawn, part.pixels);
    }
    if (seen_.size() > 2 * seenAtLast_ + kFewArrivals)
    {
        forgetHidden(painter, projector, resting);
    }
    return drawn;
}

void StaticLayer::forgetHidden(ScenePainter& painter, const SphereProjector& projector,
                               std::span<const SphereInstance> resting)
{
    spheres_.clear();
    for (const Seen& seen : seen_)
    {
        spheres_.push_back(resting[seen.index]);
    }
    findHidden(painter, projector);
    std::erase_if(seen_,
                  [&](const Seen& seen) { return hides(projector.project(resting[seen.index])); });
    seenAtLast_ = seen_.size();
}

PixelRectangle StaticLayer::repaint(ScenePainter& painter, std::span<const SphereInstance> resting,
                                    const PixelRectangle& wanted, const Framebuffer& scratch)
{
    const PixelRectangle part = grown(wanted, kScissorMargin);
    spheres_.clear();
    for (const Seen& seen : seen_)
    {
        if (seen.pixels.overlaps(part))
        {
            spheres_.push_back(resting[seen.index]);
        }
    }
    scratch.bind();
    painter.confine(part);
    painter.clear();
    painter.paintGround();
    painter.paintSpheres(spheres_);
    const PicturePart all{part};
    painter.paintShell({&all, 1});
    painter.endConfinement();
    framebuffer_.restore(scratch, wanted);
    return grown(part, kScissorMargin);
}

PixelRectangle StaticLayer::visiblePart(std::size_t resting) const
{
    const auto place =
        std::lower_bound(seen_.begin(), seen_.end(), resting,
                         [](const Seen& seen, std::size_t index) { return seen.index < index; });
    return place != seen_.end() && place->index == resting ? place->pixels : PixelRectangle{};
}

namespace
{

/// Edge of a block [pixel]. Smaller ones know more of small spheres and take longer to ask.
constexpr int kBlock = 4;

constexpr int blocks(int pixels)
{
    return (pixels + kBlock - 1) / kBlock;
}

} // namespace

OcclusionMap::OcclusionMap(int width, int height)
    : columns_(blocks(width)), furthest_(static_cast<std::size_t>(blocks(width) * blocks(height)))
{
}

void OcclusionMap::build(const PixelRectangle& part, std::span<const std::uint32_t> depths)
{
    assert(depths.size() == static_cast<std::size_t>(part.area()));
    known_ = true;
    // Blocks that are not all in the part hide nothing.
    std::fill(furthest_.begin(), furthest_.end(), 1.0F);
    for (int y = blocks(part.bottom); y < part.top / kBlock; ++y)
    {
        for (int x = blocks(part.left); x < part.right / kBlock; ++x)
        {
            std::uint32_t furthest = 0;
            for (int row = 0; row < kBlock; ++row)
            {
                const std::uint32_t* from =
                    depths.data() + std::ptrdiff_t{y * kBlock + row - part.bottom} * part.width() +
                    (x * kBlock - part.left);
                furthest = std::max(furthest, *std::max_element(from, from + kBlock));
            }
            furthest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(x)] =
                static_cast<float>((furthest >> 8) / double{0xffffff});
        }
    }
}

bool OcclusionMap::hides(const ProjectedSphere& sphere) const
{
    if (!known_ || sphere.pixels.empty())
    {
        return false;
    }
    const int right = (sphere.pixels.right - 1) / kBlock;
    const int top = (sphere.pixels.top - 1) / kBlock;
    for (int y = sphere.pixels.bottom / kBlock; y <= top; ++y)
    {
        const float* row = furthest_.data() + static_cast<std::ptrdiff_t>(y) * columns_;
        for (int x = sphere.pixels.left / kBlock; x <= right; ++x)
        {
            if (row[x] >= sphere.nearestDepth)
            {
                return false;
            }
        }
    }
    return true;
}

} // namespace frostfill
