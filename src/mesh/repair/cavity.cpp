// SPDX-License-Identifier: MIT
#include "mesh/repair/cavity.hpp"

#include "mesh/repair/clean_mesh.hpp"
#include "mesh/repair/components.hpp"
#include "mesh/repair/orient_mesh.hpp"
#include "mesh/repair/rims.hpp"
#include "mesh/skin/enclosed_cells.hpp"
#include "mesh/triangle_shape.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

/// [1] Of the volume of the largest part. Larger: compartments of a tray stay empty. Smaller: pores
/// in the walls and gaps between ribs are filled too.
constexpr double kLeastPart = 0.05;

/// [1] Of the volume of the box. The walls of a vessel take less, and its cavity more than they.
constexpr double kMostWalls = 0.5;

/// A connected part of the surface that may bound a cavity.
struct Part
{
    PieceSize size;  ///< its volume is that with lids
    double lids = 0; ///< [unit^2]
    bool isOpen = false;
};

/// The triangles that face a room or are of a shell within another one, turned.
TriangleMesh inwardFaces(const TriangleMesh& walls)
{
    const std::vector<bool> faces = facesRooms(walls);
    const std::vector<std::size_t> depths = depthsOfPieces(walls);
    TriangleMesh surface{walls.vertices, {}};
    for (std::size_t i = 0; i < walls.triangles.size(); ++i)
    {
        const auto& [a, b, c] = walls.triangles[i];
        if (faces[i] || depths[i] > 0)
        {
            surface.triangles.push_back({a, c, b});
        }
    }
    return surface;
}

std::vector<Part> partsOf(const TriangleMesh& surface, const EdgeTable& edges,
                          const std::vector<std::vector<std::uint32_t>>& pieces,
                          const std::vector<std::size_t>& pieceOf)
{
    std::vector<Part> parts(pieces.size());
    std::vector<Eigen::Vector3d> origins;
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        origins.push_back(surface.vertices[surface.triangles[pieces[i][0]][0]]);
        for (const std::uint32_t triangle : pieces[i])
        {
            parts[i].size.add(surface, surface.triangles[triangle], origins[i]);
        }
    }
    for (const Rim& rim : findRims(edges))
    {
        const std::size_t i = pieceOf[edges.find(rim[0], rim[1])[0].triangle];
        const Eigen::Vector3d middle = middleOf(surface, rim);
        parts[i].isOpen = true;
        parts[i].size.volume += volumeOfLid(surface, rim, origins[i]);
        for (std::size_t k = 0; k < rim.size(); ++k)
        {
            const Eigen::Vector3d& next = surface.vertices[rim[(k + 1) % rim.size()]];
            parts[i].lids += 0.5 * (surface.vertices[rim[k]] - middle).cross(next - middle).norm();
        }
    }
    return parts;
}

} // namespace

Cavity findCavity(const TriangleMesh& walls)
{
    Cavity cavity{inwardFaces(walls)};
    const EdgeTable edges(cavity.surface);
    const auto pieces = connectedPieces(cavity.surface, edges);
    std::vector<std::size_t> pieceOf(cavity.surface.triangles.size(), 0);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        for (const std::uint32_t triangle : pieces[i])
        {
            pieceOf[triangle] = i;
        }
    }
    const std::vector<Part> parts = partsOf(cavity.surface, edges, pieces, pieceOf);
    double largest = 0;
    for (const Part& part : parts)
    {
        largest = std::max(largest, part.size.volume);
    }
    std::vector<bool> isKept;
    for (const Part& part : parts)
    {
        isKept.push_back(part.size.volume > 0 && part.size.volume >= kLeastPart * largest);
        cavity.volume += isKept.back() ? part.size.volume : 0;
        cavity.areaOfLids += isKept.back() ? part.lids : 0;
        cavity.hasClosedPart = cavity.hasClosedPart || (isKept.back() && !part.isOpen);
    }
    // Solids in a cavity, whose surfaces are wound inwards here.
    const auto isWithin = [&](const Part& solid)
    {
        bool found = false;
        for (std::size_t i = 0; i < parts.size(); ++i)
        {
            found = found || (isKept[i] && parts[i].size.volume > 0 &&
                              parts[i].size.box.contains(solid.size.box));
        }
        return found;
    };
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        if (!parts[i].isOpen && parts[i].size.volume < 0 && isWithin(parts[i]))
        {
            isKept[i] = true;
            cavity.volume += parts[i].size.volume;
        }
    }
    eraseTriangles(cavity.surface, [&](std::uint32_t i) { return !isKept[pieceOf[i]]; });
    dropUnusedVertices(cavity.surface);
    return cavity;
}

std::string cavityHint(const TriangleMesh& mesh, const MeshReport& report)
{
    const bool mayBeWalls = report.volume < kMostWalls * report.box.volume();
    if (!mayBeWalls && report.components == 1)
    {
        return "";
    }
    const Cavity cavity = findCavity(mesh);
    const bool isVessel = mayBeWalls && cavity.volume > report.volume &&
                          cavity.areaOfLids < surfaceArea(cavity.surface);
    if (!cavity.hasClosedPart && !isVessel)
    {
        return "";
    }
    return fmt::format("the walls are filled, and not the cavity of volume {:.4g} that they "
                       "enclose; {} fills the cavity",
                       cavity.volume, cavity.areaOfLids > 0 ? "--cavity --lid" : "--cavity");
}

} // namespace frostfill
