// SPDX-License-Identifier: MIT
#include "render/picture/picture_backend.hpp"

#include "render/framing/framing.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

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
    if (settings.size.width < 1 || settings.size.height < 1)
    {
        throw Error(ErrorCode::usage, fmt::format("a picture of {}x{} pixels cannot be drawn",
                                                  settings.size.width, settings.size.height));
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
      still_(frameBesideLegend(vertices_, settings_, legend_)), framing_(still_)
{
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
        moved_ = true;
        renew();
    }
    return changes;
}

void Viewpoint::renew()
{
    framing_ = turned_ != 0 ? revolved(still_, settings_.up, turned_) : still_;
    if (moved_)
    {
        framing_ = posed(framing_, pose_, origin_);
    }
}

PictureBackend::PictureBackend(const TriangleMesh& mesh, const RenderSettings& settings)
    : viewpoint_(mesh, settings), shell_(mesh, settings, viewpoint_.framing())
{
}

void PictureBackend::lookFrom(const Camera& camera)
{
    viewpoint_.lookFrom(camera);
    if (shell_.lookFrom(viewpoint_.framing()))
    {
        useShell();
    }
    useFraming();
}

void PictureBackend::turn(double degrees)
{
    if (viewpoint_.turn(degrees))
    {
        useFraming();
    }
}

void PictureBackend::follow(const Snapshot& snapshot)
{
    if (viewpoint_.follow(snapshot))
    {
        useFraming();
    }
}

} // namespace frostfill
