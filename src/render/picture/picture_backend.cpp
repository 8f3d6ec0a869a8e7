// SPDX-License-Identifier: MIT
#include "render/picture/picture_backend.hpp"

#include "render/framing/framing.hpp"
#include "render/picture/painter_settings.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <utility>

namespace frostfill
{

namespace
{

/// More samples a pixel than this are not to be had from OSMesa.
constexpr int kMaxSamples = 4;

/// Refuses what cannot be drawn, and finds the front of the object.
RenderSettings checked(const RenderSettings& wanted, const TriangleMesh& mesh)
{
    RenderSettings settings = wanted;
    if (settings.samples < 1 || settings.samples > kMaxSamples)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("samples per pixel must be between 1 and {}, not {}", kMaxSamples,
                                settings.samples));
    }
    if (!settings.camera.azimuth)
    {
        settings.camera.azimuth = frontAzimuth(mesh, settings.up.normalized());
    }
    return settings;
}

} // namespace

Viewpoint::Viewpoint(const TriangleMesh& mesh, const RenderSettings& wanted)
    : settings_(checked(wanted, mesh)), vertices_(verticesInPoses(mesh.vertices, wanted.poses)),
      colours_(settings_, vertices_), legend_(settings_, mesh.triangles.size(), colours_),
      still_(frameBesideLegend(vertices_, settings_, legend_)),
      variant_(variantOf(settings_, mesh)), studio_(studioOf(mesh, settings_, still_))
{
    renew();
}

void Viewpoint::lookFrom(const Camera& camera)
{
    if (camera.orthographic != framing_.orthographic)
    {
        throw Error(ErrorCode::usage,
                    "a renderer cannot change between perspective and parallel projection");
    }
    const double azimuth = *settings_.camera.azimuth;
    settings_.camera = camera;
    settings_.camera.azimuth = camera.azimuth.value_or(azimuth);
    still_ = frameBesideLegend(vertices_, settings_, legend_);
    turned_ = 0;
    renew();
}

bool Viewpoint::turn(double degrees)
{
    const bool changes = degrees != turned_;
    if (changes)
    {
        turned_ = degrees;
        renew();
    }
    return changes;
}

bool Viewpoint::follow(const Snapshot& snapshot)
{
    const bool changes =
        snapshot.pose.rotation != pose_.rotation || snapshot.pose.offset != pose_.offset;
    if (changes)
    {
        pose_ = snapshot.pose;
        origin_ = snapshot.origin;
        renew();
    }
    return changes;
}

void Viewpoint::renew()
{
    const Framing turned = turned_ != 0 ? revolved(still_, settings_.up, turned_) : still_;
    framing_ = posed(turned, pose_, origin_);
    uniforms_ = uniformsOf(framing_, settings_);
    if (studio_)
    {
        studio_->light(framing_, uniforms_);
    }
}

PictureBackend::PictureBackend(const TriangleMesh& mesh, const RenderSettings& settings)
    : viewpoint_(mesh, settings),
      shell_(mesh, settings, viewpoint_.framing(), viewpoint_.variant().fadingLines)
{
    if (viewpoint_.variant().occlusion)
    {
        sphereOcclusion_.emplace(lampOf(viewpoint_.studio()),
                                 cutPlanesOf(viewpoint_.settings(), viewpoint_.framing()));
    }
}

void PictureBackend::lookFrom(const Camera& camera)
{
    viewpoint_.lookFrom(camera);
    renew();
}

void PictureBackend::turn(double degrees)
{
    if (viewpoint_.turn(degrees))
    {
        renew();
    }
}

void PictureBackend::follow(const Snapshot& snapshot)
{
    if (viewpoint_.follow(snapshot))
    {
        renew();
    }
}

void PictureBackend::renew()
{
    stale_ = true;
    if (shell_.lookFrom(framing()))
    {
        useShell();
    }
    useFraming();
}

PictureBackend::Changes PictureBackend::take(const Snapshot& snapshot, bool cells)
{
    follow(snapshot);
    const SphereDrawList::Changes& changes =
        drawList_.update(snapshot, framing(), viewpoint_.colours());
    const bool startAgain = std::exchange(stale_, false) || changes.everything;
    std::size_t first = changes.firstArrival; // of what stands where it did not
    if (startAgain)
    {
        const bool inCells = cells && drawList_.resting().size() >= kCellsFrom;
        if (!inCells || drawList_.orderByCells())
        {
            first = 0;
        }
        if (!inCells && drawList_.resting().size() >= kSortFrom)
        {
            drawList_.sortFrontToBack(framing());
        }
    }
    if (sphereOcclusion_)
    {
        sphereOcclusion_->follow(drawList_.resting(), first);
    }
    return {changes, shell_.follow(snapshot.polygons), startAgain};
}

} // namespace frostfill
