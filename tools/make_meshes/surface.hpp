// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <vector>

/// Faces of three or four corners, counter-clockwise seen from outside.
struct Surface
{
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::vector<int>> faces;
};

/// Triangles only; what the polygoniser and the decimation work on.
struct Triangles
{
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<int, 3>> faces;
};

/// Signed distance, or nearly: negative inside, zero on the surface.
using Field = std::function<double(const Eigen::Vector3d&)>;

/// Ring in the x-y plane about the z axis, standing on its rim.
Surface makeTorus(double radius, double tube, int around, int across);
/// Poles on the y axis.
Surface makeSphere(double radius, int around, int rings);
Surface makeCube(double edge, int quadsAlongEdge);

/// A standing human of about 1.8 m that faces +z, feet near y = 0.
double humanField(const Eigen::Vector3d& point);

/// The zero set of a field inside a box, by marching tetrahedra: always closed and manifold.
Triangles polygonise(const Field& field, const Eigen::AlignedBox3d& box, double cell);

/// The nearest point of the zero set, by Newton steps along the gradient.
Eigen::Vector3d projectToSurface(const Field& field, Eigen::Vector3d point);

/// Collapses edges, the cheapest by quadric error first, until `vertexCount` vertices are left.
/// Keeps the surface manifold and its genus, and new vertices on the zero set of `field`.
Triangles decimate(const Triangles& fine, const Field& field, std::size_t vertexCount);

/// Flips edges towards fat triangles and slides vertices along the zero set, `rounds` times.
void evenOut(Triangles& mesh, const Field& field, int rounds);
