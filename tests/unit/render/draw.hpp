// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/renderer.hpp>

namespace frostfill::test
{

/// One picture, by a renderer of its own.
inline Image draw(const TriangleMesh& mesh, const RenderSettings& settings,
                  const Snapshot& snapshot = {})
{
    Image image;
    Renderer(mesh, settings).render(snapshot, image);
    return image;
}

} // namespace frostfill::test
