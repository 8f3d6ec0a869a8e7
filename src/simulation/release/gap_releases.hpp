// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/release/release_rule.hpp"
#include "simulation/release/release_sites.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace frostfill
{

/// Classes of radii, the largest first. The largest spheres fill the object; those of each smaller
/// class then go anywhere they fit, into the gaps above all, until there are as many of them as the
/// size curve asks for beside the largest, or no place is left for them.
class GapReleases final : public ReleasePart
{
public:
    /// `world`, whose radii have a size curve, and `threads` outlive this. `band`: see
    /// ReleaseSites.
    GapReleases(const World& world, double band, Threads& threads);

    [[nodiscard]] std::optional<PlacedSphere> next(const ReleaseQuery& query) override;
    [[nodiscard]] std::optional<Eigen::Vector3d> place(double radius,
                                                       const ReleaseQuery& query) override;
    [[nodiscard]] bool any() override { return sites_ && sites_->any(); }
    void close(const Eigen::Vector3d& centre, double radius) override;

private:
    struct Class
    {
        double low;  ///< share of the number that is smaller
        double high; ///< and of those up to its largest radius, for which its sites are
        double largest;
        std::size_t placed = 0;
    };
    void enter(std::size_t index);
    [[nodiscard]] bool isComplete() const;
    [[nodiscard]] double radiusOfDraw(std::uint64_t number) const;

    const World& world_;
    Threads& threads_;
    double band_;
    std::vector<Class> classes_; ///< descending
    std::size_t current_ = 0;
    std::optional<ReleaseSites> sites_; ///< of the current class
    double all_ = 0;                    ///< spheres of all classes; known once the largest are in
    std::optional<double> drawn_;
    std::uint64_t draws_ = 0;
};

} // namespace frostfill
