// SPDX-License-Identifier: MIT
// Room: where and when spheres appear. It finds release sites that are clear, and adds the
// spheres of a set to the world.
#pragma once

#include "scene/size_ledger.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/release/release_sites.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace frostfill
{

/// What appears next: a radius drawn from the run's distribution, and a place for it. The radii are
/// sorted into a few classes; each class has sites of its own, at which its largest radius fits. As
/// an object only fills up, a class for which no place is left is done with: from then on radii are
/// drawn from what is below it. So "full" means that not even the smallest radius finds a place.
/// Radii of a size curve are drawn evenly; once some find no place, the run ends when the curve
/// would be off by more than its scene allows.
class Releases final : public ReleasePart
{
public:
    /// `world` and `threads` outlive this. `band`: see ReleaseSites.
    Releases(const World& world, double band, Threads& threads);

    [[nodiscard]] std::optional<PlacedSphere> next(const ReleaseQuery& query) override;
    [[nodiscard]] std::optional<Eigen::Vector3d> place(double radius,
                                                       const ReleaseQuery& query) override;
    /// Of a size curve all radii have to find a place at first, or it could not be kept.
    [[nodiscard]] bool any() override
    {
        return (ledger_ && !ranOut_ ? classes_.back() : classes_.front()).sites->any();
    }
    void close(const Eigen::Vector3d& centre, double radius) override;

private:
    struct Class
    {
        double largest; ///< radius, for which its sites are
        std::unique_ptr<ReleaseSites> sites;
        bool isCoarse = false; ///< places may be left that its sites do not lead to
    };
    [[nodiscard]] bool findsMore(Class& one);
    [[nodiscard]] std::function<void()> computingAhead(double radius, const ReleaseQuery& query);
    void computeAhead(double radius, const ReleaseQuery& query);
    [[nodiscard]] double radiusOfDraw(std::uint64_t number) const;
    void dropClasses(std::size_t from);
    [[nodiscard]] bool drawRadius();
    [[nodiscard]] std::size_t classOf(double radius) const;

    const World& world_;
    Threads& threads_;
    std::vector<Class> classes_;  ///< ascending; those that are done with are gone, but the first
    std::optional<double> drawn_; ///< the next radius, for which there was no place yet
    std::uint64_t draws_ = 0;
    std::optional<SizeLedger> ledger_; ///< of a size curve
    bool ranOut_ = false;              ///< some sizes find no place any more
    struct Unknown
    {
        const ReleaseSites* sites;
        Draw* draw;
    };
    std::vector<Unknown> unknown_; ///< draws that are computed next
};

} // namespace frostfill
