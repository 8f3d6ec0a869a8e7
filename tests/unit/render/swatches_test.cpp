// SPDX-License-Identifier: MIT
// The legend shows what there is in the picture: its swatches have the colours that are found
// there.
#include "render/picture/picture_backend.hpp"
#include "support/drawn_with.hpp"

#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// A square that faces the viewer.
TriangleMesh wall()
{
    TriangleMesh mesh;
    mesh.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

void expectColoursOfPolygons(RenderSettings settings, PolygonState state, Backend backend)
{
    settings.backend = backend;
    const TriangleMesh mesh = wall();
    Snapshot snapshot;
    snapshot.polygons.assign(2, state);
    Renderer renderer(mesh, settings);
    Image image;
    renderer.render(snapshot, image);
    const Viewpoint viewpoint(mesh, settings);
    const auto& [left, top, right, bottom] = viewpoint.framing().region;
    // Beside the middle, through which the diagonal runs.
    const auto* polygon = image.at(static_cast<int>((5 * left + 4 * right) / 9),
                                   static_cast<int>((4 * top + 5 * bottom) / 9));
    ASSERT_EQ(viewpoint.legend().polygons().size(), 2U);
    for (const Legend::Swatch& swatch : viewpoint.legend().polygons())
    {
        const auto* shown = image.at(static_cast<int>(swatch.x), static_cast<int>(swatch.y));
        int largest = 0;
        for (int c = 0; c < 3; ++c)
        {
            largest = std::max(largest, std::abs(shown[c] - polygon[c]));
        }
        const bool own = swatch.state == static_cast<int>(state);
        EXPECT_EQ(largest <= 2, own)
            << int{shown[0]} << " " << int{shown[1]} << " " << int{shown[2]} << " in the swatch, "
            << int{polygon[0]} << " " << int{polygon[1]} << " " << int{polygon[2]}
            << " on the polygon";
    }
}

void expectColoursOfPolygons(const RenderSettings& settings, PolygonState state)
{
    for (const Backend backend : test::backends())
    {
        SCOPED_TRACE(static_cast<int>(backend));
        expectColoursOfPolygons(settings, state, backend);
    }
}

RenderSettings seenFaceOn()
{
    RenderSettings settings;
    settings.camera.azimuth = 0;
    settings.camera.elevation = 0;
    settings.style.edges = EdgeLines::off;
    settings.style.shellOpacity = 0.6; // so that states are far apart
    return settings;
}

TEST(Swatches, OfPolygonsHaveTheColourOfPolygonsThatAreSeenFaceOn)
{
    for (const Look look : {Look::clean, Look::dark, Look::studio})
    {
        for (const bool orthographic : {false, true})
        {
            for (const PolygonState state : {PolygonState::active, PolygonState::discarded})
            {
                RenderSettings settings = seenFaceOn();
                settings.style.look = look;
                settings.style.palette = paletteOf(look);
                settings.camera.orthographic = orthographic;
                settings.samples = orthographic ? 1 : 4;
                expectColoursOfPolygons(settings, state);
            }
        }
    }
}

TEST(Swatches, OfPolygonsAreTheSameBesideACutaway)
{
    for (const PolygonState state : {PolygonState::active, PolygonState::discarded})
    {
        RenderSettings settings = seenFaceOn();
        settings.style.cutaway = {Cutaway::Kind::plane, {1, 0, 0}, 0.9, 0, 90};
        expectColoursOfPolygons(settings, state);
    }
}

} // namespace
} // namespace frostfill
