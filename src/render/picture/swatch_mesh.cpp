// SPDX-License-Identifier: MIT
#include "render/picture/swatch_mesh.hpp"

#include <frostfill/mesh.hpp>

namespace frostfill
{
namespace
{

/// Two triangles for each swatch, which face the viewer.
TriangleMesh squares(const std::vector<Legend::Swatch>& swatches, double height)
{
    TriangleMesh mesh;
    for (const Legend::Swatch& swatch : swatches)
    {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        {
            mesh.vertices.emplace_back(swatch.x + x * swatch.halfSize,
                                       height - swatch.y + y * swatch.halfSize, 0);
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    return mesh;
}

} // namespace

SwatchShapes swatchShapes(const Legend& legend, const SphereColours& colours, int height)
{
    SwatchShapes shapes;
    for (const Legend::Swatch& swatch : legend.spheres())
    {
        const auto state = static_cast<SphereState>(swatch.state);
        shapes.spheres.push_back(
            {static_cast<float>(swatch.x), static_cast<float>(height - swatch.y), 0,
             static_cast<float>(swatch.halfSize), static_cast<std::uint32_t>(colours.marked(state)),
             colours.ofSwatch(state)});
    }
    const TriangleMesh mesh = squares(legend.polygons(), height);
    std::vector<glm::vec3> positions;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        positions.emplace_back(vertex.x(), vertex.y(), vertex.z());
    }
    shapes.polygons = shadeMesh(mesh, positions);
    shapes.strengths = edgeStrengths(shapes.polygons, {0, 0, 1}, true);
    for (std::size_t t = 0; t + 1 < shapes.strengths.size(); t += 2)
    {
        shapes.strengths[t][1] = shapes.strengths[t + 1][2] = 0; // the diagonals
    }
    for (const Legend::Swatch& swatch : legend.polygons())
    {
        shapes.states.insert(shapes.states.end(), 2, static_cast<PolygonState>(swatch.state));
    }
    return shapes;
}

glm::mat4 pixelProjection(const PictureSize& size)
{
    glm::mat4 projection(0);
    projection[0][0] = 2.0F / static_cast<float>(size.width);
    projection[1][1] = 2.0F / static_cast<float>(size.height);
    projection[2][2] = -1e-6F;
    projection[3] = {-1, -1, -0.9999F, 1};
    return projection;
}

} // namespace frostfill
