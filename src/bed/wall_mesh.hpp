// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/surface.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The triangles of a closed surface while points and edges are added to them: it stays closed, and
/// its shape changes by no more than rounding. Vertices are in single precision.
class WallMesh
{
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFF;

    /// What a triangle has become.
    struct Piece
    {
        std::array<std::uint32_t, 3> corner{};
        /// Across the edge from each corner to the next; kNone where not exactly two triangles
        /// meet.
        std::array<std::uint32_t, 3> beyond{};
        std::uint32_t plane = 0;       ///< triangle of the surface in which it lies
        std::array<bool, 3> isFixed{}; ///< edges that stay
        bool isHole = false;
    };

    /// `groups`: edges between triangles of different ones stay.
    WallMesh(const Surface& surface, std::span<const std::uint8_t> groups);

    [[nodiscard]] std::size_t size() const { return pieces_.size(); }
    [[nodiscard]] const Piece& operator[](std::uint32_t piece) const { return pieces_[piece]; }
    [[nodiscard]] const Eigen::Vector3d& vertex(std::uint32_t v) const { return vertices_[v]; }
    /// Unit, out of the surface.
    [[nodiscard]] Eigen::Vector3d normal(std::uint32_t piece) const
    {
        return -surface_->bound(pieces_[piece].plane).normal;
    }
    /// Whether an edge only divides a plane, so that another one may take its place.
    [[nodiscard]] bool isFree(std::uint32_t piece, std::size_t edge) const;
    /// The pieces around a vertex; empty where they do not surround it.
    [[nodiscard]] std::vector<std::uint32_t> around(std::uint32_t v) const;
    [[nodiscard]] static std::size_t placeOf(const Piece& piece, std::uint32_t v);

    /// Adds a vertex within a piece, or on an edge.
    std::uint32_t addWithin(std::uint32_t piece, const Eigen::Vector3d& p);
    std::uint32_t addOn(std::uint32_t piece, std::size_t edge, const Eigen::Vector3d& p);
    /// Flips edges near a vertex until triangles of one plane are those of Delaunay.
    void improveAround(std::uint32_t v);
    /// Keeps an edge.
    void fix(std::uint32_t piece, std::size_t edge);
    void makeHole(std::uint32_t piece) { touch(piece).isHole = true; }

    /// What is done from here on can be taken back.
    void begin();
    void takeBack();
    /// Pieces that have changed since, the new ones included.
    [[nodiscard]] std::vector<std::uint32_t> changed() const;

private:
    Piece& touch(std::uint32_t piece);
    std::uint32_t add(const Piece& piece);
    std::uint32_t addVertex(const Eigen::Vector3d& p);
    void rejoin(std::uint32_t piece, std::uint32_t before, std::uint32_t now);
    void turn(std::uint32_t piece, std::size_t edge);
    std::uint32_t turnBoth(std::uint32_t piece, std::size_t edge);
    void flip(std::uint32_t piece, std::size_t edge);
    void own(std::uint32_t piece);
    [[nodiscard]] bool isBetterFlipped(std::uint32_t piece, std::size_t edge) const;

    const Surface* surface_;
    std::span<const std::uint8_t> groups_;
    std::vector<Eigen::Vector3d> vertices_;
    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> pieceAt_; ///< [#vertices] one that has it as a corner
    // Since begin().
    std::vector<std::pair<std::uint32_t, Piece>> earlier_;
    std::size_t verticesBefore_ = 0;
    std::size_t piecesBefore_ = 0;
};

} // namespace frostfill
