// SPDX-License-Identifier: MIT
// Room: where and when spheres appear. It finds release sites that are clear, and adds the
// spheres of a set to the world.
#pragma once

#include "scene/size_ledger.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/release/release_sites.hpp"

#include <cstdint>
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
