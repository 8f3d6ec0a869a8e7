// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/release/release_rule.hpp"

#include <optional>
#include <vector>

namespace frostfill
{

/// Spheres appear at random places in the scene's inlets, within the openings to kOffInInlet. An
/// inlet is chosen with a probability in proportion to its area. When the heap below leaves no room
/// in any of them, nothing appears any more, however much of the object is empty.
class Inlets final : public ReleasePart
{
public:
    /// The world outlives this. Throws Error usage for an inlet outside of the object, one that is
    /// narrower than the largest sphere, and one that walls leave no room in.
    explicit Inlets(const World& world);

    [[nodiscard]] std::optional<PlacedSphere> next(const ReleaseQuery& query) override;
    [[nodiscard]] std::optional<Eigen::Vector3d> place(double radius,
                                                       const ReleaseQuery& query) override;
    [[nodiscard]] bool any() override;
    [[nodiscard]] bool findsEveryPlace() const override { return false; }
    void close(const Eigen::Vector3d& /*centre*/, double /*radius*/) override {}

private:
    struct Opening
    {
        Eigen::Vector3d centre; ///< [r]
        double radius;          ///< [r]
        double share;           ///< of the area of all, up to this one
    };
    [[nodiscard]] Eigen::Vector3d draw(double radius);
    [[nodiscard]] Eigen::Vector3d placeIn(const Opening& opening, double radius,
                                          std::uint64_t number) const;
    [[nodiscard]] bool isClear(Eigen::Vector3d& place, double radius) const;
    [[nodiscard]] bool letsIn(const Opening& opening) const;

    const World& world_;
    std::vector<Opening> openings_;
    std::optional<double> radius_; ///< the next one, for which there was no place yet
    std::uint64_t radii_ = 0;      ///< radii drawn so far
    std::uint64_t draws_ = 0;      ///< places drawn so far
};

} // namespace frostfill
