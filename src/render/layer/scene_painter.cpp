// SPDX-License-Identifier: MIT
#include "render/layer/scene_painter.hpp"

#include "render/picture/painter_settings.hpp"
#include "render/picture/projected_sphere.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace frostfill
{

namespace
{

/// A sphere that is smaller by this, and by as far as the outermost sample is from a pixel's
/// centre, covers a centre only where the full one covers all samples of the pixel, and lies in
/// front of the small one there. For rounding. [pixel]
constexpr float kOccluderSlack = 0.1F;

ShaderVariant uncut(ShaderVariant variant)
{
    variant.cutaway = false;
    return variant;
}

} // namespace

ScenePainter::ScenePainter(const GlFunctions& gl, const Viewpoint& viewpoint,
                           const DrawnShell& shell, std::size_t triangles,
                           SphereOcclusion* occlusion, std::span<const glm::vec2> samplePositions)
    : gl_(gl), viewpoint_(viewpoint), drawnShell_(shell), sphereOcclusion_(occlusion),
      spherePass_(gl, uncut(viewpoint.variant()), samplePositions, viewpoint.settings().style,
                  strokesFor(viewpoint.settings()).lineWidth),
      meshPass_(gl, viewpoint.variant(), shellPalette(viewpoint.settings().style),
                strokesFor(viewpoint.settings(), triangles)),
      spheres_(gl, occlusion != nullptr)
{
    const Style& style = viewpoint.settings().style;
    const float lineWidth = strokesFor(viewpoint.settings()).lineWidth;
    if (viewpoint.variant().cutaway)
    {
        cutSpherePass_.emplace(gl, viewpoint.variant(), samplePositions, style, lineWidth);
    }
    if (viewpoint.studio() && viewpoint.studio()->ground)
    {
        ground_ = std::make_unique<GroundPass>(gl_, *viewpoint.studio()->ground);
    }
    useShell();
    useFraming();
    for (const glm::vec2& sample : samplePositions)
    {
        occluderShrink_ = std::max(occluderShrink_, glm::length(sample) + kOccluderSlack);
    }
    if (samplePositions.size() > 1 && paintsOccluders())
    {
        plainSpherePass_.emplace(gl_, shapesOnly(viewpoint.variant()), std::span<const glm::vec2>(),
                                 style, lineWidth);
    }
}

void ScenePainter::useShell()
{
    if (viewpoint_.settings().style.shell)
    {
        shell_ = std::make_unique<MeshBuffer>(gl_, drawnShell_.shaded());
    }
}

void ScenePainter::findBounds()
{
    const SphereProjector projector(viewpoint_.framing(), viewpoint_.settings().size);
    const ShadedMesh& mesh = drawnShell_.shaded();
    bounds_.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const auto [a, b, c] = mesh.corners(t);
        const glm::vec3 middle = (a + b + c) / 3.0F;
        const float reach = std::max(
            {glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
        bounds_.push_back(
            projector.project({middle.x, middle.y, middle.z, 1.0001F * reach + 1e-6F, 0}));
    }
}

void ScenePainter::useFraming()
{
    if (shell_)
    {
        shell_->setEdges(drawnShell_.edges());
        findBounds();
    }
}

PixelRectangle ScenePainter::setPolygons(std::span<const std::uint32_t> changed,
                                         std::span<const PolygonState> states)
{
    PixelRectangle part;
    if (shell_)
    {
        shell_->update(changed, states);
        for (const std::uint32_t triangle : changed)
        {
            part = around(part, bounds_[triangle].pixels);
        }
    }
    return part;
}

void ScenePainter::clear()
{
    const glm::vec4 background = toVector(viewpoint_.settings().style.palette.background);
    // Colours are premultiplied by alpha until they are read.
    gl_.clearColor(background.r * background.a, background.g * background.a,
                   background.b * background.a, background.a);
    gl_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void ScenePainter::paintGround()
{
    if (ground_ && viewpoint_.studio()->showsGround(viewpoint_.framing()))
    {
        ground_->draw(viewpoint_.uniforms());
    }
}

void ScenePainter::confine(const PixelRectangle& part)
{
    gl_.enable(GL_SCISSOR_TEST);
    gl_.scissor(part.left, part.bottom, part.width(), part.height());
}

void ScenePainter::endConfinement()
{
    gl_.disable(GL_SCISSOR_TEST);
}

void ScenePainter::paintSpheres(std::span<const SphereInstance> spheres)
{
    if (!cutSpherePass_)
    {
        paintSpheres(spheres, spherePass_);
        return;
    }
    whole_.clear();
    cut_.clear();
    for (const SphereInstance& sphere : spheres)
    {
        const CutShare share = cutShareOf(sphere, viewpoint_.uniforms());
        if (share != CutShare::nothing)
        {
            (share == CutShare::whole ? whole_ : cut_).push_back(sphere);
        }
    }
    paintSpheres(whole_, spherePass_);
    paintSpheres(cut_, *cutSpherePass_);
}

void ScenePainter::paintSpheres(std::span<const SphereInstance> spheres, const SpherePass& pass)
{
    if (spheres.empty())
    {
        return;
    }
    spheres_.update(spheres);
    if (sphereOcclusion_ != nullptr)
    {
        lights_.clear();
        for (const SphereInstance& sphere : spheres)
        {
            lights_.push_back(sphereOcclusion_->of(sphere));
        }
        spheres_.light(lights_);
    }
    pass.draw(spheres_, viewpoint_.uniforms());
}

void ScenePainter::paintOccluders(std::span<const SphereInstance> spheres,
                                  const SphereProjector& projector)
{
    shrunk_.clear();
    for (SphereInstance sphere : spheres)
    {
        const float ahead = viewpoint_.framing().orthographic ? 1 : projector.project(sphere).ahead;
        sphere.radius -= occluderShrink_ * ahead / viewpoint_.uniforms().pixelScale;
        if (sphere.radius > 0 && ahead > 0)
        {
            shrunk_.push_back(sphere);
        }
    }
    if (!shrunk_.empty())
    {
        spheres_.update(shrunk_);
        plainSpherePass_->draw(spheres_, viewpoint_.uniforms());
    }
}

void ScenePainter::paintShell()
{
    const auto& [width, height] = viewpoint_.settings().size;
    const PicturePart all{{0, 0, width, height}};
    paintShell({&all, 1});
}

void ScenePainter::paintShell(std::span<const PicturePart> parts)
{
    if (!shell_)
    {
        return;
    }
    chosen_.clear();
    for (std::uint32_t t = 0; t < bounds_.size(); ++t)
    {
        const auto meets = [&bounds = bounds_[t]](const PicturePart& part)
        { return bounds.nearestDepth < part.furthest && bounds.pixels.overlaps(part.pixels); };
        if (std::any_of(parts.begin(), parts.end(), meets))
        {
            chosen_.push_back(t);
        }
    }
    shell_->choose(chosen_);
    meshPass_.draw(*shell_, viewpoint_.uniforms());
}

void ScenePainter::addSpheres(std::span<const SphereInstance> spheres,
                              std::span<const PicturePart> parts)
{
    if (spheres.empty())
    {
        return;
    }
    gl_.enable(GL_STENCIL_TEST);
    gl_.stencilFunc(GL_ALWAYS, 1, 0xff);
    gl_.stencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    paintSpheres(spheres);
    // Only what shows a new sphere has lost the surface over it; elsewhere it must not lie twice.
    gl_.stencilFunc(GL_EQUAL, 1, 0xff);
    gl_.stencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    // A triangle reaches far beyond a sphere that it covers a piece of, and with several samples
    // Mesa shades it there too before it finds no mark.
    PixelRectangle region;
    for (const PicturePart& part : parts)
    {
        region = around(region, grown(part.pixels, kScissorMargin));
    }
    confine(region);
    paintShell(parts);
    gl_.clear(GL_STENCIL_BUFFER_BIT);
    endConfinement();
    gl_.disable(GL_STENCIL_TEST);
}

} // namespace frostfill
