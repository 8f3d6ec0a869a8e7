// SPDX-License-Identifier: MIT
#include "render/framing/pose_framing.hpp"

#include <Eigen/Geometry>
#include <glm/matrix.hpp>

namespace frostfill
{

std::vector<Eigen::Vector3d> verticesInPoses(const std::vector<Eigen::Vector3d>& mesh,
                                             const std::vector<Pose>& poses)
{
    if (poses.empty())
    {
        return mesh;
    }
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : mesh)
    {
        box.extend(vertex);
    }
    const Eigen::Vector3d origin = box.center();
    std::vector<Eigen::Vector3d> vertices;
    for (const Pose& pose : poses)
    {
        for (const Eigen::Vector3d& vertex : mesh)
        {
            vertices.emplace_back(origin + pose.offset + pose.rotation * (vertex - origin));
        }
    }
    return vertices;
}

Framing posed(const Framing& framing, const Pose& pose, const Eigen::Vector3d& origin)
{
    // The pose as a matrix of unit space.
    const Eigen::Vector3d fromCentre = origin - framing.centre;
    const Eigen::Vector3d shift =
        framing.scale * (fromCentre + pose.offset - pose.rotation * fromCentre);
    glm::dmat4 matrix(1);
    for (int column = 0; column < 3; ++column)
    {
        for (int row = 0; row < 3; ++row)
        {
            matrix[column][row] = pose.rotation(row, column);
        }
        matrix[3][column] = shift[column];
    }
    Framing result = framing;
    result.view = framing.view * matrix;
    const double isPoint = framing.orthographic ? 0 : 1;
    result.eye = glm::dvec3(glm::inverse(matrix) * glm::dvec4(framing.eye, isPoint));
    return result;
}

} // namespace frostfill
