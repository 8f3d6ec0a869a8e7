// SPDX-License-Identifier: MIT
#include "render/picture/drawn_shell.hpp"

#include "support/drawn_with.hpp"
#include "support/pictures.hpp"

#include <frostfill/image.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using testing_support::torusMesh;

/// 60,000 triangles before a camera.
class DenseShell : public testing::Test
{
protected:
    DenseShell() { settings_.size = {320, 180}; }

    [[nodiscard]] Framing framing(double zoom = 1) const
    {
        RenderSettings settings = settings_;
        settings.camera.zoom = zoom;
        settings.camera.azimuth = 30;
        return frame(mesh_.vertices, settings, {0, 0, 320, 180});
    }

    TriangleMesh mesh_ = torusMesh(1, 0.4, 300, 100);
    RenderSettings settings_;
};

TEST_F(DenseShell, IsWithinOneAndAHalfPixelsOfTheMeshFromNearAndFar)
{
    DrawnShell shell(mesh_, settings_, framing(), true);
    EXPECT_LT(shell.mesh().triangles.size(), mesh_.triangles.size() / 5);
    for (const double zoom : {1.0, 3.0, 0.5})
    {
        const Framing own = framing(zoom);
        shell.lookFrom(own);
        // At the place that is nearest to the eye.
        const double pixelsPerUnit =
            own.projection[1][1] * settings_.size.height / 2 / (glm::length(own.eye) - 1);
        const double limit = 1.5 / pixelsPerUnit / own.scale;
        EXPECT_TRUE(distanceBound(mesh_, shell.mesh(), limit)) << zoom;
        EXPECT_TRUE(distanceBound(shell.mesh(), mesh_, limit)) << zoom;
    }
}

TEST_F(DenseShell, DependsOnTheCameraAndNotOnThoseBefore)
{
    DrawnShell shell(mesh_, settings_, framing(), true);
    const auto before = shell.mesh().triangles;
    EXPECT_FALSE(shell.lookFrom(framing(1.01)));
    EXPECT_TRUE(shell.lookFrom(framing(4)));
    EXPECT_GT(shell.mesh().triangles.size(), before.size());
    EXPECT_TRUE(shell.lookFrom(framing()));
    EXPECT_EQ(shell.mesh().triangles, before);
}

TEST_F(DenseShell, HasTheStatesOfTheTrianglesAround)
{
    DrawnShell shell(mesh_, settings_, framing(), true);
    std::vector<PolygonState> states;
    const auto isLow = [](const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle)
    {
        return std::all_of(triangle.begin(), triangle.end(),
                           [&](std::uint32_t vertex) { return mesh.vertices[vertex].y() < 0; });
    };
    for (const auto& triangle : mesh_.triangles)
    {
        states.push_back(isLow(mesh_, triangle) ? PolygonState::discarded : PolygonState::active);
    }
    const std::size_t changed = shell.follow(states).size();
    const auto shown = shell.states();
    ASSERT_EQ(shown.size(), shell.mesh().triangles.size());
    std::size_t low = 0;
    for (std::size_t t = 0; t < shown.size(); ++t)
    {
        const bool is = isLow(shell.mesh(), shell.mesh().triangles[t]);
        EXPECT_EQ(shown[t] == PolygonState::discarded, is) << t;
        low += is ? 1 : 0;
    }
    EXPECT_GT(low, shown.size() / 3);
    EXPECT_EQ(changed, low);
    EXPECT_TRUE(shell.follow(states).empty());
    EXPECT_EQ(shell.follow({}).size(), low) << "all are active again";
}

TEST_F(DenseShell, IsTheMeshWhereThatIsAskedForOrItsEdgesAreShownOrTrianglesAreFew)
{
    settings_.style.edges = EdgeLines::on;
    EXPECT_EQ(DrawnShell(mesh_, settings_, framing(), true).mesh().triangles, mesh_.triangles);
    settings_.style.edges = EdgeLines::automatic;
    settings_.style.fullMesh = true;
    EXPECT_EQ(DrawnShell(mesh_, settings_, framing(), true).mesh().triangles, mesh_.triangles);
    settings_.style.fullMesh = false;
    mesh_ = torusMesh(1, 0.4, 100, 100);
    EXPECT_EQ(DrawnShell(mesh_, settings_, framing(), true).mesh().triangles, mesh_.triangles);
}

TEST_F(DenseShell, FacesWhereTheTrueSurfaceDoesInItsSliversToo)
{
    const DrawnShell shell(mesh_, settings_, framing(), true);
    const ShadedMesh& shaded = shell.shaded();
    for (std::size_t t = 0; t < shaded.triangles.size(); ++t)
    {
        const auto [a, b, c] = shaded.corners(t);
        const glm::vec3 middle = (a + b + c) / 3.0F;
        const glm::vec3 around = glm::normalize(glm::vec3(middle.x, middle.y, 0));
        const auto ring = static_cast<float>(framing().scale); // the axis of the tube
        const glm::vec3 normal = glm::normalize(middle - ring * around);
        EXPECT_GT(glm::dot(shaded.faceNormals[t], normal), 0.85F) << t;
    }
    EXPECT_TRUE(std::all_of(shaded.edges.begin(), shaded.edges.end(),
                            [](const ShadedMesh::Edge& edge) { return edge.crease == 0; }));
}

/// A mesh of half as many triangles as are simplified shows the same torus.
TEST_F(DenseShell, LooksLikeAMeshOfFewerTrianglesInEveryBackend)
{
    const TriangleMesh coarse = torusMesh(1, 0.4, 140, 70);
    for (const Backend backend : test::backends())
    {
        settings_.backend = backend;
        settings_.style.legend = false;
        Image dense;
        Image fewer;
        Renderer(mesh_, settings_).render({}, dense);
        Renderer(coarse, settings_).render({}, fewer);
        EXPECT_LT(compareImages(dense, fewer).rootMeanSquare, 4);
    }
}

} // namespace
} // namespace frostfill
