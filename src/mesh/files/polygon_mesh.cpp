// SPDX-License-Identifier: MIT
#include "mesh/files/polygon_mesh.hpp"

#include "mesh/polygon_cutter.hpp"

namespace frostfill
{
namespace
{

constexpr std::int64_t kLargestIndex = 0xfffffffe;

/// Takes out corners that follow themselves: they add no side.
void dropRepeats(std::vector<std::uint32_t>& corners)
{
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    while (corners.size() > 1 && corners.front() == corners.back())
    {
        corners.pop_back();
    }
}

} // namespace

void PolygonMesh::reserve(std::uint64_t vertices, std::uint64_t faces)
{
    vertices_.reserve(vertices);
    faces_.reserve(faces);
    corners_.reserve(3 * faces);
}

void PolygonMesh::addVertex(const std::array<double, 3>& position)
{
    vertices_.emplace_back(position[0], position[1], position[2]);
}

void PolygonMesh::refuseIndex(std::uint64_t place, std::int64_t corner) const
{
    refuseAt({unit_, place},
             fmt::format("the face names vertex {}, but the file has {} (numbered from {}); export "
                         "the mesh again",
                         corner + firstIndex_, vertices_.size(), firstIndex_));
}

std::uint32_t PolygonMesh::checked(std::uint64_t place, std::int64_t corner) const
{
    if (corner < 0 || corner > kLargestIndex)
    {
        refuseIndex(place, corner);
    }
    return static_cast<std::uint32_t>(corner);
}

void PolygonMesh::addFace(std::uint64_t place, std::span<const std::int64_t> corners)
{
    for (const std::int64_t corner : corners)
    {
        corners_.push_back(checked(place, corner));
    }
    if (corners.size() < 3)
    {
        corners_.resize(corners_.size() - corners.size());
        hasLines_ = true;
        return;
    }
    faces_.push_back({place, corners_.size()});
}

void PolygonMesh::addStrips(std::uint64_t place, std::span<const std::int64_t> corners)
{
    std::size_t first = 0; // of the strip
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        if (corners[i] == -1)
        {
            first = i + 1;
            continue;
        }
        std::ignore = checked(place, corners[i]);
        if (i < first + 2)
        {
            continue;
        }
        std::array<std::int64_t, 3> t = {corners[i - 2], corners[i - 1], corners[i]};
        if ((i - first) % 2 == 1)
        {
            std::swap(t[0], t[1]);
        }
        // A corner that is there twice leads the strip elsewhere.
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        {
            addFace(place, t);
        }
    }
}

TriangleMesh PolygonMesh::take()
{
    if (faces_.empty())
    {
        throw Unreadable(vertices_.empty()
                             ? "it holds neither vertices nor faces; export the mesh again"
                             : fmt::format("it holds {} vertices but no faces, {}, so there is "
                                           "nothing to fill; export the surface as triangles",
                                           vertices_.size(),
                                           hasLines_ ? "only points and lines" : "a point cloud"));
    }
    TriangleMesh mesh;
    mesh.triangles.reserve(corners_.size() - 2 * faces_.size());
    PolygonCutter cutter(vertices_);
    std::vector<std::uint32_t> polygon;
    std::size_t begin = 0;
    for (const Face& face : faces_)
    {
        for (std::size_t i = begin; i < face.end; ++i)
        {
            if (corners_[i] >= vertices_.size())
            {
                refuseIndex(face.place, corners_[i]);
            }
        }
        if (face.end - begin == 3)
        {
            mesh.triangles.push_back({corners_[begin], corners_[begin + 1], corners_[begin + 2]});
        }
        else
        {
            polygon.assign(corners_.begin() + static_cast<std::ptrdiff_t>(begin),
                           corners_.begin() + static_cast<std::ptrdiff_t>(face.end));
            dropRepeats(polygon);
            if (polygon.size() >= 3 && !cutter.cut(polygon, mesh.triangles))
            {
                refuseAt({unit_, face.place},
                         fmt::format("a polygon of {} corners takes too long to cut into "
                                     "triangles; triangulate the mesh before you export it",
                                     polygon.size()));
            }
        }
        begin = face.end;
    }
    mesh.vertices = std::move(vertices_);
    return mesh;
}

} // namespace frostfill
