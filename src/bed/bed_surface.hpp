// SPDX-License-Identifier: MIT
#pragma once

#include "bed/geodesic_sphere.hpp"
#include "bed/links.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace frostfill
{

using StlTriangle = std::array<Eigen::Vector3f, 3>;

/// The boundary of what spheres leave free in their container, closed, in single precision. Normals
/// point out of the free space.
class BedSurface
{
public:
    /// Throws Error badData as findLinks.
    explicit BedSurface(const Bed& bed);

    [[nodiscard]] const Bed& bed() const { return bed_; }
    [[nodiscard]] const BedLinks& links() const { return links_; }
    /// Of a patch of the bed.
    [[nodiscard]] std::size_t triangles(std::size_t patch) const { return counts_[patch]; }
    [[nodiscard]] std::size_t triangles() const;

    /// Calls sink(triangles) for one part of a patch after another, in the same order for any
    /// number of threads. Parts are made in parallel.
    using Sink = std::function<void(std::span<const StlTriangle>)>;
    void forEachPart(std::size_t patch, const Sink& sink) const;

    /// [unit^3] of the free space, by the divergence theorem.
    [[nodiscard]] double freeVolume() const { return freeVolume_; }
    /// [1] of the container as it was.
    [[nodiscard]] double porosity() const { return freeVolume_ / bed_.containerVolume(); }

private:
    void addSphere(std::uint32_t sphere, std::vector<StlTriangle>& triangles) const;

    const Bed& bed_;
    TriangleMesh geodesic_;
    BedLinks links_;
    std::vector<std::vector<StlTriangle>> walls_; ///< of all patches but the spheres
    std::vector<std::size_t> counts_;
    double freeVolume_ = 0;
};

} // namespace frostfill
