// SPDX-License-Identifier: MIT
#include "geometry/closest_point.hpp"
#include "mesh/repair/repair_steps.hpp"

#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace frostfill
{
namespace
{

/// [1] Cubes along the edge of a cube as large as the mesh's box, to tell rooms. Larger: walls and
/// mouths may be narrower. Smaller: less time; 64 takes ten milliseconds.
constexpr double kRoomCells = 64;
/// Of the 26 directions to neighbours, those that end at walls in a room: above the 13 before a
/// plane, below the 17 at the rim of a cup.
constexpr int kWallsOfRoom = 16;
/// [edge of a cube] How far in front of a triangle a free cube is looked for.
constexpr int kStepsToRoom = 3;
/// A byte each.
constexpr double kMaxCells = 16e6;
/// Cubes looked at, for all triangles: a second.
constexpr std::size_t kMaxLooks = 100'000'000;

class Cells
{
public:
    Cells(const Eigen::AlignedBox3d& box, double edge) : low_(box.min()), edge_(edge)
    {
        const Eigen::Vector3d counts = (box.sizes() / edge).array().ceil() + 2 * kMargin;
        if (counts.prod() > kMaxCells)
        {
            return;
        }
        low_ -= Eigen::Vector3d::Constant(kMargin * edge);
        counts_ = counts.cast<int>();
        state_.assign(static_cast<std::size_t>(counts_.prod()), kFree);
    }

    /// Marks the cubes near all triangles. False when there are too many cubes, or that would take
    /// too long.
    [[nodiscard]] bool block(const TriangleMesh& mesh)
    {
        return !state_.empty() &&
               std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                           [&](const auto& t) {
                               return block(mesh.vertices[t[0]], mesh.vertices[t[1]],
                                            mesh.vertices[t[2]]);
                           });
    }

    /// Marks all cubes that a triangle meets, and some beside. Returns false when that would take
    /// too long.
    [[nodiscard]] bool block(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c)
    {
        const double reach = std::sqrt(0.75) * edge_;
        const Eigen::Array3d low = a.cwiseMin(b).cwiseMin(c).array() - reach;
        const Eigen::Array3d high = a.cwiseMax(b).cwiseMax(c).array() + reach;
        const Eigen::Array3i first = cell(low).max(0);
        const Eigen::Array3i last = cell(high).min(counts_ - 1);
        looks_ += static_cast<std::size_t>((last - first + 1).cast<double>().prod());
        if (looks_ > kMaxLooks)
        {
            return false;
        }
        for (int z = first.z(); z <= last.z(); ++z)
        {
            for (int y = first.y(); y <= last.y(); ++y)
            {
                for (int x = first.x(); x <= last.x(); ++x)
                {
                    char& state = state_[index(x, y, z)];
                    const Eigen::Vector3d middle =
                        low_ + edge_ * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
                    if (state == kFree &&
                        (closestPointOnTriangle(middle, a, b, c).point - middle).norm() <= reach)
                    {
                        state = kBlocked;
                    }
                }
            }
        }
        return true;
    }

    /// Whether most directions from the first free cube in front of a triangle end at walls;
    /// nothing where there is none near.
    [[nodiscard]] std::optional<bool> facesRoom(const Eigen::Vector3d& middle,
                                                const Eigen::Vector3d& normal)
    {
        for (int step = 1; step <= kStepsToRoom; ++step)
        {
            const Eigen::Array3i at = cell((middle + step * edge_ * normal).array());
            if ((at < 0).any() || (at >= counts_).any())
            {
                return false;
            }
            char& state = state_[index(at.x(), at.y(), at.z())];
            if (state == kFree)
            {
                state = wallsAround(at) >= kWallsOfRoom ? kRoom : kOutside;
            }
            if (state != kBlocked)
            {
                return state == kRoom;
            }
        }
        return std::nullopt;
    }

private:
    static constexpr double kMargin = 2; // cubes around the box
    static constexpr char kFree = 0;
    static constexpr char kBlocked = 1;
    static constexpr char kRoom = 2;
    static constexpr char kOutside = 3;

    /// Of the 26 directions to neighbours, those in which a blocked cube lies.
    [[nodiscard]] int wallsAround(const Eigen::Array3i& from) const
    {
        int walls = 0;
        for (int direction = 0; direction < 27; ++direction)
        {
            const Eigen::Array3i step(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
            Eigen::Array3i at = from + step;
            while (direction != 13 && (at >= 0).all() && (at < counts_).all())
            {
                if (state_[index(at.x(), at.y(), at.z())] == kBlocked)
                {
                    ++walls;
                    break;
                }
                at += step;
            }
        }
        return walls;
    }

    [[nodiscard]] Eigen::Array3i cell(const Eigen::Array3d& p) const
    {
        return ((p - low_.array()) / edge_).floor().cast<int>();
    }
    [[nodiscard]] std::size_t index(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * counts_.y() + y) * counts_.x() + x;
    }

    Eigen::Vector3d low_;
    double edge_;
    std::size_t looks_ = 0;
    Eigen::Array3i counts_ = Eigen::Array3i::Zero();
    std::vector<char> state_;
};

/// [#T] Which triangles face a room that the surface mostly encloses, closed or open, such as the
/// inside of a cup. False for all where that would take too long.
std::vector<bool> facesRooms(const TriangleMesh& mesh)
{
    std::vector<bool> faces(mesh.triangles.size(), false);
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    Cells cells(box, std::max(std::cbrt(box.volume()) / kRoomCells,
                              box.sizes().maxCoeff() / (4 * kRoomCells)));
    if (!cells.block(mesh))
    {
        return faces;
    }
    std::vector<std::uint32_t> known;
    std::vector<bool> isKnown(mesh.triangles.size(), false);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
    {
        const auto [a, b, c] = cornersOf(mesh, i);
        const auto faced =
            cells.facesRoom((a + b + c) / 3, (b - a).cross(c - a).stableNormalized());
        if (faced)
        {
            faces[i] = *faced;
            isKnown[i] = true;
            known.push_back(i);
        }
    }
    // In a corner no free cube is near. Such triangles are like those beside them.
    const VertexTriangles around(mesh);
    for (std::size_t k = 0; k < known.size(); ++k)
    {
        for (const std::uint32_t corner : mesh.triangles[known[k]])
        {
            for (const std::uint32_t other : around.at(corner))
            {
                if (!isKnown[other])
                {
                    faces[other] = faces[known[k]];
                    isKnown[other] = true;
                    known.push_back(other);
                }
            }
        }
    }
    return faces;
}

/// [1] Of the volume of the largest part. Larger: compartments of a tray stay empty. Smaller: pores
/// in the walls and gaps between ribs are filled too.
constexpr double kLeastPart = 0.05;

/// [1] Of the volume of the box. The walls of a vessel take less, and its cavity more than they.
constexpr double kMostWalls = 0.5;

/// The triangles that face a room or are of a shell within another one, turned.
TriangleMesh inwardFaces(const TriangleMesh& walls)
{
    const std::vector<bool> faces = facesRooms(walls);
    const Pieces pieces(walls, EdgeTable(walls));
    const std::vector<std::size_t> depths = depthsOf(walls, pieces.all);
    TriangleMesh surface{walls.vertices, {}};
    for (std::size_t i = 0; i < walls.triangles.size(); ++i)
    {
        const auto& [a, b, c] = walls.triangles[i];
        if (faces[i] || (pieces.of[i] != Pieces::kNone && depths[pieces.of[i]] > 0))
        {
            surface.triangles.push_back({a, c, b});
        }
    }
    return surface;
}

} // namespace

Cavity findCavity(const TriangleMesh& walls)
{
    Cavity cavity{inwardFaces(walls)};
    const Pieces pieces(cavity.surface, EdgeTable(cavity.surface));
    double largest = 0;
    for (const Piece& piece : pieces.all)
    {
        largest = std::max(largest, piece.size.volume);
    }
    std::vector<const Piece*> kept;
    for (const Piece& piece : pieces.all)
    {
        if (piece.size.volume > 0 && piece.size.volume >= kLeastPart * largest)
        {
            kept.push_back(&piece);
            cavity.areaOfLids += piece.lids;
            cavity.hasClosedPart = cavity.hasClosedPart || piece.edgesOfRims == 0;
        }
    }
    // Solids in a cavity, whose surfaces are wound inwards here.
    const std::vector<const Piece*> cavities = kept;
    for (const Piece& solid : pieces.all)
    {
        if (solid.edgesOfRims == 0 && solid.size.volume < 0 &&
            std::any_of(cavities.begin(), cavities.end(),
                        [&](const Piece* piece)
                        { return piece->size.box.contains(solid.size.box); }))
        {
            kept.push_back(&solid);
        }
    }
    for (const Piece* piece : kept)
    {
        cavity.volume += piece->size.volume;
    }
    pieces.erase(cavity.surface, [&](const Piece& piece)
                 { return std::find(kept.begin(), kept.end(), &piece) == kept.end(); });
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
