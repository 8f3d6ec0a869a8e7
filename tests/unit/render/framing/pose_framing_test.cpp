// SPDX-License-Identifier: MIT
#include "render/framing/framing.hpp"
#include "support/pictures.hpp"

#include <Eigen/Geometry>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using namespace testing_support;

const Eigen::Vector3d kOrigin(5, -3, 2);

Pose turnedAndShifted(double angle)
{
    Pose pose;
    pose.rotation =
        Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    pose.offset = {0.4, -0.7, 1.1};
    return pose;
}

/// Where a point of the mesh is, as snapshot.hpp says.
Eigen::Vector3d inWorld(const Pose& pose, const Eigen::Vector3d& point)
{
    return kOrigin + pose.offset + pose.rotation * (point - kOrigin);
}

TEST(PoseFraming, SeesEveryPointWhereItsPoseBringsIt)
{
    const TriangleMesh mesh = boxMesh({1, 2, 3}, kOrigin);
    RenderSettings settings;
    settings.camera.azimuth = 50;
    const Pose pose = turnedAndShifted(0.9);
    for (const bool orthographic : {false, true})
    {
        settings.camera.orthographic = orthographic;
        const Framing still = frame(mesh.vertices, settings, {0, 0, 640, 360});
        const Framing moved = posed(still, pose, kOrigin);
        for (const Eigen::Vector3d& vertex : mesh.vertices)
        {
            const glm::dvec4 there = moved.view * glm::dvec4(moved.toUnit(vertex), 1);
            const glm::dvec4 asked =
                still.view * glm::dvec4(still.toUnit(inWorld(pose, vertex)), 1);
            EXPECT_LT(glm::distance(there, asked), 1e-12);
            // The eye is asked in the frame of the mesh: it is as far from the point there.
            if (!orthographic)
            {
                EXPECT_NEAR(glm::distance(moved.eye, moved.toUnit(vertex)),
                            glm::distance(still.eye, still.toUnit(inWorld(pose, vertex))), 1e-12);
            }
        }
    }
}

TEST(PoseFraming, HasEveryVertexInEveryPose)
{
    const TriangleMesh mesh = boxMesh({1, 2, 3}, kOrigin);
    EXPECT_EQ(verticesInPoses(mesh.vertices, {}), mesh.vertices);
    const std::vector<Pose> poses = {turnedAndShifted(0.3), turnedAndShifted(2.5)};
    const std::vector<Eigen::Vector3d> vertices = verticesInPoses(mesh.vertices, poses);
    ASSERT_EQ(vertices.size(), 2 * mesh.vertices.size());
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
        const std::size_t vertex = k % mesh.vertices.size();
        const Pose& pose = poses[k / mesh.vertices.size()];
        EXPECT_LT((vertices[k] - inWorld(pose, mesh.vertices[vertex])).norm(), 1e-12);
    }
}

} // namespace
} // namespace frostfill
