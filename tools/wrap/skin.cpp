// SPDX-License-Identifier: GPL-3.0-or-later
#include "work.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

namespace frostfill::wrap
{

TriangleMesh skinOf(const TriangleMesh& mesh, double alpha, double offset)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Skin = CGAL::Surface_mesh<Kernel::Point_3>;

    std::vector<Kernel::Point_3> points;
    for (const Eigen::Vector3d& v : mesh.vertices)
    {
        points.emplace_back(v.x(), v.y(), v.z());
    }
    std::vector<std::array<std::size_t, 3>> faces;
    for (const auto& t : mesh.triangles)
    {
        if (!CGAL::collinear(points[t[0]], points[t[1]], points[t[2]]))
        {
            faces.push_back({t[0], t[1], t[2]});
        }
    }
    if (faces.empty())
    {
        throw Refused("none of its triangles has an area");
    }
    Skin skin;
    CGAL::alpha_wrap_3(points, faces, alpha, offset, skin);

    TriangleMesh result;
    for (const auto vertex : skin.vertices())
    {
        const Kernel::Point_3& p = skin.point(vertex);
        result.vertices.emplace_back(p.x(), p.y(), p.z());
    }
    for (const auto face : skin.faces())
    {
        std::array<std::uint32_t, 3> t{};
        std::size_t corner = 0;
        for (const auto vertex : CGAL::vertices_around_face(skin.halfedge(face), skin))
        {
            t.at(corner++) = static_cast<std::uint32_t>(vertex);
        }
        result.triangles.push_back(t);
    }
    return result;
}

} // namespace frostfill::wrap
