// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/files/unreadable.hpp"

#include <frostfill/mesh.hpp>

#include <span>

namespace frostfill
{

/// The vertices and polygons of a file while it is read. Faces may come before their vertices.
class PolygonMesh
{
public:
    /// `unit` is that of the places of faces; `firstIndex` is how the format numbers its first
    /// vertex.
    explicit PolygonMesh(std::string_view unit, int firstIndex = 0)
        : unit_(unit), firstIndex_(firstIndex)
    {
    }

    void reserve(std::uint64_t vertices, std::uint64_t faces);
    [[nodiscard]] std::size_t vertexCount() const { return vertices_.size(); }
    void addVertex(const std::array<double, 3>& position);

    /// Corners count from 0. What has fewer than three is a point or a line, and left out.
    void addFace(std::uint64_t place, std::span<const std::int64_t> corners);

    /// A strip of triangles, or several, with an index of -1 between them.
    void addStrips(std::uint64_t place, std::span<const std::int64_t> corners);

    /// Checks all indices and cuts the polygons into triangles. Throws Unreadable, also if there is
    /// no face.
    [[nodiscard]] TriangleMesh take();

private:
    struct Face
    {
        std::uint64_t place = 0;
        std::size_t end = 0; ///< of its corners in corners_
    };

    [[nodiscard]] std::uint32_t checked(std::uint64_t place, std::int64_t corner) const;
    [[noreturn]] void refuseIndex(std::uint64_t place, std::int64_t corner) const;

    std::string_view unit_;
    int firstIndex_;
    std::vector<Eigen::Vector3d> vertices_;
    std::vector<std::uint32_t> corners_;
    std::vector<Face> faces_;
    bool hasLines_ = false;
};

} // namespace frostfill
