// SPDX-License-Identifier: MIT
#include "render/picture/mesh_shading.hpp"

#include "support/pictures.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace frostfill
{
namespace
{

using namespace testing_support;

ShadedMesh shade(const TriangleMesh& mesh)
{
    std::vector<glm::vec3> positions;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
    }
    return shadeMesh(mesh, positions);
}

TEST(MeshShading, BoxKeepsItsTwelveEdgesAndItsFlatFaces)
{
    const ShadedMesh box = shade(boxMesh({1, 2, 3}));
    EXPECT_EQ(box.edges.size(), 18U);
    EXPECT_EQ(std::count_if(box.edges.begin(), box.edges.end(),
                            [](const ShadedMesh::Edge& edge) { return edge.crease; }),
              12);
    for (std::size_t t = 0; t < box.triangles.size(); ++t)
    {
        for (const std::uint32_t corner : box.triangles[t])
        {
            const glm::vec3& normal = box.normals[corner];
            EXPECT_GT(glm::dot(normal, box.faceNormals[t]), 0.99999F);
            EXPECT_GT(glm::dot(normal, box.corners(t)[0]), 0.0F) << "points inwards";
        }
    }
}

TEST(MeshShading, TorusIsSmoothAndHasNoCrease)
{
    const ShadedMesh torus = shade(torusMesh(1, 0.4, 48, 12));
    for (const ShadedMesh::Edge& edge : torus.edges)
    {
        ASSERT_FALSE(edge.crease);
    }
    for (std::size_t t = 0; t < torus.triangles.size(); ++t)
    {
        for (std::size_t c = 0; c < 3; ++c)
        {
            const glm::vec3 p = torus.corners(t)[c];
            const glm::vec3 ring = glm::normalize(glm::vec3(p.x, p.y, 0));
            ASSERT_GT(glm::dot(torus.normals[torus.triangles[t][c]], glm::normalize(p - ring)),
                      0.99F);
        }
    }
}

TEST(MeshShading, OutlineIsDrawnAndDependsOnTheEye)
{
    const ShadedMesh torus = shade(torusMesh(1, 0.4, 48, 12));
    const auto strong = [&](const glm::vec3& eye)
    {
        std::size_t count = 0;
        for (const auto& triangle : edgeStrengths(torus, eye, true))
        {
            count += static_cast<std::size_t>(
                std::count_if(triangle.begin(), triangle.end(), [](int s) { return s > 100; }));
        }
        return count;
    };
    // Along the axis the outline is two rings of 48 edges, each seen in two triangles. The widest
    // ring lies between two strips of which one faces the viewer.
    EXPECT_EQ(strong({0, 0, 1}), 2U * 2U * 48U);
    EXPECT_NE(strong({1, 0.1F, 0.2F}), strong({0, 0, 1}));
}

TEST(MeshShading, ABendOfMoreThan35DegreesIsACreaseAndNotSmoothedOver)
{
    for (const double degrees : {0.0, 30.0, 34.0, 36.0, 50.0, 90.0, 150.0})
    {
        const double bend = degrees * std::numbers::pi / 180;
        TriangleMesh hinge; // about the x axis
        hinge.vertices = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, std::cos(bend), std::sin(bend)}};
        hinge.triangles = {{0, 2, 1}, {0, 1, 3}};
        const ShadedMesh shaded = shade(hinge);
        const auto edge = std::find_if(shaded.edges.begin(), shaded.edges.end(),
                                       [](const ShadedMesh::Edge& each)
                                       { return each.triangles[1] != ShadedMesh::Edge::kNone; });
        ASSERT_NE(edge, shaded.edges.end());
        const bool isCrease = degrees > 35;
        EXPECT_EQ(edge->crease != 0, isCrease) << degrees;
        // Smooth normals at the hinge are half way between both faces.
        const double cosine =
            glm::dot(shaded.normals[shaded.triangles[0][0]], shaded.faceNormals[0]);
        EXPECT_NEAR(cosine, isCrease ? 1 : std::cos(bend / 2), 1e-5) << degrees;
    }
}

TEST(MeshShading, ARoughScanHasHardlyAnyCreasesAndIsSmooth)
{
    TriangleMesh mesh = torusMesh(1, 0.4, 480, 160);
    std::mt19937 random(1);
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        for (double& x : vertex)
        {
            x += 0.006 * (static_cast<double>(random()) / 4294967296.0 - 0.5); // half an edge
        }
    }
    const ShadedMesh rough = shade(mesh);
    const auto isBent = [](const ShadedMesh::Edge& edge) { return edge.crease != 0; };
    const auto isCrease = [](const ShadedMesh::Edge& edge)
    { return edge.crease != 0 && !edge.stray; };
    EXPECT_GT(std::count_if(rough.edges.begin(), rough.edges.end(), isBent), 1000);
    EXPECT_LT(20 * std::count_if(rough.edges.begin(), rough.edges.end(), isCrease),
              std::count_if(rough.edges.begin(), rough.edges.end(), isBent));
    double least = 1;
    for (std::size_t t = 0; t < rough.triangles.size(); ++t)
    {
        const glm::vec3 p = rough.corners(t)[0];
        const glm::vec3 ring = glm::normalize(glm::vec3(p.x, p.y, 0));
        least = std::min<double>(
            least, glm::dot(rough.normals[rough.triangles[t][0]], glm::normalize(p - ring)));
    }
    EXPECT_GT(least, 0.5);
}

TEST(MeshShading, RimOfAHoleIsDrawn)
{
    TriangleMesh mesh = boxMesh({1, 1, 1});
    mesh.triangles.resize(1);
    const ShadedMesh single = shade(mesh);
    EXPECT_EQ(single.edges.size(), 3U);
    const auto strengths = edgeStrengths(single, {0, 0, 5}, false);
    for (const std::uint8_t strength : strengths[0])
    {
        EXPECT_GT(strength, 100);
    }
}

TEST(MeshShading, TriangleWithoutAreaGivesFiniteNormals)
{
    TriangleMesh mesh = boxMesh({1, 1, 1});
    mesh.triangles.push_back({0, 0, 1});
    const ShadedMesh shaded = shade(mesh);
    EXPECT_EQ(shaded.normals.size(), shaded.positions.size());
    for (const glm::vec3& normal : shaded.normals)
    {
        EXPECT_TRUE(std::isfinite(glm::length(normal)));
    }
    EXPECT_EQ(shaded.corners(mesh.triangles.size() - 1),
              (std::array{shaded.positions[shaded.triangles.back()[0]],
                          shaded.positions[shaded.triangles.back()[0]],
                          shaded.positions[shaded.triangles.back()[2]]}));
}

} // namespace
} // namespace frostfill
