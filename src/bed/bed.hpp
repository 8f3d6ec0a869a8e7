// SPDX-License-Identifier: MIT
// Room: a packing as geometry for other programs: one closed surface of spheres and walls, cases of
// OpenFOAM and gmsh, and volumes of distances and labels.
#pragma once

#include "base/threads.hpp"
#include "bulk/sphere_levels.hpp"
#include "mesh/interior/surface.hpp"

#include <frostfill/bed.hpp>
#include <frostfill/mesh.hpp>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace frostfill
{

/// The role of a part of the surface in a flow.
enum class PatchKind : std::uint8_t
{
    inlet,  ///< the flat foot of the container, if it has one
    outlet, ///< its flat top
    wall,
    spheres,
};
inline constexpr std::array<const char*, 4> kPatchNames = {"inlet", "outlet", "wall", "spheres"};

/// Part of the surface, a patch of OpenFOAM or a solid of STL.
struct BedPatch
{
    PatchKind kind = PatchKind::wall;
    std::string name;

    auto operator<=>(const BedPatch&) const = default; // NOLINT(modernize-use-nullptr): of 14
};

/// A closed mesh, wound outwards, which may have been read in parts.
struct BedContainer
{
    static constexpr std::uint32_t kNoPart = 0xFFFFFFFF;

    TriangleMesh mesh;
    std::vector<std::string> parts = {};    ///< their names; each comes once
    std::vector<std::uint32_t> partOf = {}; ///< [#T] places in parts, or kNoPart; empty: none has
};

/// Spheres in a closed container, in the world.
class Bed
{
public:
    /// `up` is a unit vector, from foot to top. Throws Error badData where there is no sphere.
    Bed(const BedContainer& container, std::vector<Eigen::Vector3d> centres,
        std::vector<double> radii, const Eigen::Vector3d& up, const BedSettings& settings,
        double unitsPerMetre = 1);

    [[nodiscard]] const BedSettings& settings() const { return settings_; }
    [[nodiscard]] const TriangleMesh& mesh() const { return surface_.mesh(); }
    [[nodiscard]] const Surface& surface() const { return surface_; }
    [[nodiscard]] const SphereLevels& levels() const { return levels_; }
    [[nodiscard]] Threads& threads() const { return *threads_; }
    [[nodiscard]] const Eigen::Vector3d& up() const { return up_; }
    [[nodiscard]] std::size_t size() const { return radii_.size(); }
    [[nodiscard]] const Eigen::Vector3d& centre(std::size_t k) const { return centres_[k]; }
    /// Before any treatment.
    [[nodiscard]] double radius(std::size_t k) const { return radii_[k]; }
    /// As the geometry has it.
    [[nodiscard]] double treatedRadius(std::size_t k) const
    {
        return settings_.contacts == ContactTreatment::shrink ? settings_.factor * radii_[k]
                                                              : radii_[k];
    }
    [[nodiscard]] double meanDiameter() const { return meanDiameter_; }
    [[nodiscard]] double unitsPerMetre() const { return unitsPerMetre_; }
    /// All that have a triangle, by kind; that of the spheres comes last.
    [[nodiscard]] const std::vector<BedPatch>& patches() const { return patches_; }
    /// Place in patches() of a triangle of the mesh.
    [[nodiscard]] std::size_t patch(std::size_t triangle) const { return patchOf_[triangle]; }
    [[nodiscard]] double containerVolume() const { return containerVolume_; }
    /// [1] without any treatment, of spheres that do not overlap.
    [[nodiscard]] double porosity() const;

private:
    BedSettings settings_;
    std::unique_ptr<Threads> threads_;
    std::vector<Eigen::Vector3d> centres_;
    std::vector<double> radii_;
    Eigen::Vector3d up_;
    Surface surface_;
    SphereLevels levels_;
    std::vector<BedPatch> patches_;
    std::vector<std::size_t> patchOf_; ///< [#T]
    double unitsPerMetre_;
    double meanDiameter_ = 0;
    double containerVolume_ = 0;
};

/// A sphere and a wall, or two spheres, that are near each other.
struct BedLink
{
    static constexpr std::uint32_t kWall = 0xFFFFFFFF;

    std::uint32_t first = 0;
    std::uint32_t second = kWall; ///< above first, or the wall
    double gap = 0;               ///< [unit] negative where they overlap
    Eigen::Vector3d direction;    ///< unit, from first
    double bridge = 0;            ///< [unit] radius of the cylinder; 0: both are flattened
};

/// A point as STL has it.
[[nodiscard]] inline Eigen::Vector3f inSinglePrecision(const Eigen::Vector3d& p)
{
    return p.cast<float>();
}

} // namespace frostfill
