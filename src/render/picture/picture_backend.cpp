// SPDX-License-Identifier: MIT
#include "render/picture/picture_backend.hpp"

namespace frostfill
{

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
