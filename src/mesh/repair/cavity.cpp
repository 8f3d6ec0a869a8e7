// SPDX-License-Identifier: MIT
#include "geometry/closest_point.hpp"
#include "geometry/grid_frame.hpp"
#include "mesh/repair/repair_steps.hpp"

#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
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
    Cells(const Eigen::AlignedBox3d& box, double edge)
        : frame_(GridFrame::cover(box, edge, kMargin * edge))
    {
        const auto& [x, y, z] = frame_.count;
        if (static_cast<double>(x) * y * z <= kMaxCells)
        {
            state_.assign(frame_.size(), kFree);
        }
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
        const double reach = kHalfDiagonal * frame_.cell;
        const double length = std::sqrt(std::max((b - a).squaredNorm(), (c - a).squaredNorm()));
        const auto first = frame_.coordinates(a.cwiseMin(b).cwiseMin(c).array() - reach);
        const auto last = frame_.coordinates(a.cwiseMax(b).cwiseMax(c).array() + reach);
        std::size_t looks = 1;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            looks *= static_cast<std::size_t>(last[axis] - first[axis] + 1);
        }
        looks_ += looks;
        if (looks_ > kMaxLooks)
        {
            return false;
        }
        const auto isNear = [&](const Eigen::Vector3d& p)
        {
            const double toCorner = (a - p).norm(); // decides alone for most small triangles
            return toCorner <= reach ||
                   (toCorner <= reach + length &&
                    (closestPointOnTriangle(p, a, b, c).point - p).norm() <= reach);
        };
        for (int z = first[2]; z <= last[2]; ++z)
        {
            for (int y = first[1]; y <= last[1]; ++y)
            {
                for (int x = first[0]; x <= last[0]; ++x)
                {
                    char& state = state_[frame_.index(x, y, z)];
                    state = state == kFree && isNear(frame_.centre(x, y, z)) ? kBlocked : state;
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
            const Eigen::Vector3d place = middle + step * frame_.cell * normal;
            if (!frame_.contains(place))
            {
                return false;
            }
            char& state = state_[frame_.index(place)];
            if (state == kFree)
            {
                state = isInRoom(frame_.coordinates(place)) ? kRoom : kOutside;
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

    /// Whether a blocked cube lies in enough of the 26 directions to neighbours.
    [[nodiscard]] bool isInRoom(const std::array<int, 3>& from) const
    {
        int open = 0;
        for (int direction = 0; direction < 27 && open <= 26 - kWallsOfRoom; ++direction)
        {
            const std::array<int, 3> step = {direction % 3 - 1, direction / 3 % 3 - 1,
                                             direction / 9 - 1};
            int left = std::numeric_limits<int>::max(); // steps to the end of the grid
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                const int before = from[axis];
                const int behind = frame_.count[axis] - 1 - before;
                left = step[axis] != 0 ? std::min(left, step[axis] < 0 ? before : behind) : left;
            }
            const auto stride =
                (std::ptrdiff_t{step[2]} * frame_.count[1] + step[1]) * frame_.count[0] + step[0];
            const char* at = &state_[frame_.index(from[0], from[1], from[2])];
            while (stride != 0 && left > 0 && *(at += stride) != kBlocked)
            {
                --left;
            }
            open += left == 0 ? 1 : 0;
        }
        return open <= 26 - kWallsOfRoom;
    }

    GridFrame frame_;
    std::size_t looks_ = 0;
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
TriangleMesh inwardFaces(const TriangleMesh& walls, const std::vector<bool>& faces)
{
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

/// `faces`: which triangles face a room.
Cavity cavityOf(const TriangleMesh& walls, const std::vector<bool>& faces)
{
    Cavity cavity{inwardFaces(walls, faces)};
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

} // namespace

Cavity findCavity(const TriangleMesh& walls)
{
    return cavityOf(walls, facesRooms(walls));
}

std::string cavityHint(const std::string& nameOrFile, const LoadMeshOptions& options,
                       const LoadedMesh& loaded)
{
    const MeshReport& report = loaded.report;
    const bool mayBeWalls = report.volume < kMostWalls * report.box.volume();
    if (options.cavity || isBuiltInMesh(nameOrFile) || (!mayBeWalls && report.components == 1))
    {
        return "";
    }
    const std::vector<bool> faces = facesRooms(loaded.mesh);
    double area = 0; // of a ball at least, with lids that are no larger than the walls of a cavity
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        area += faces[i] ? 2 * areaOf(loaded.mesh, loaded.mesh.triangles[i]) : 0;
    }
    if (report.components == 1 &&
        std::pow(area, 3) <= 36 * std::numbers::pi * report.volume * report.volume)
    {
        return "";
    }
    const Cavity cavity = cavityOf(loaded.mesh, faces);
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
