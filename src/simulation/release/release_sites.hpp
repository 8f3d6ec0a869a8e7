// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/release/lookahead.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/release/site_lattice.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/world/world.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace frostfill
{

/// Finds one place after another at which a sphere of one radius can be released: first at random
/// below the object's ceilings, the highest first, then, once nothing fits there, everywhere else
/// that is still free, so that "full" means that no place is left.
class ReleaseSites
{
public:
    /// `world` outlives this. `radius`: at most 1. `band`: how far below the highest ceiling [r]
    /// others are used together with it; lower ones follow as those above fill up. Negative: every
    /// free place is as good as a ceiling, in the order of the lattice.
    /// `threads`: those that long work is shared with, which outlive this.
    /// `coarsest`: see SiteLattice.
    ReleaseSites(const World& world, double radius, double band, Threads& threads,
                 double coarsest = 0);

    /// A place that is clear of walls and of spheres at rest, and what came of it.
    struct Found
    {
        Eigen::Vector3d place; ///< prepared
        bool stays;            ///< otherwise nothing is to be released from there any more
    };

    /// A place for a sphere of the radius of these sites at most. Places that do not suit now are
    /// left for later. Empty when there is none. `lookAhead`, if given, finds out the draws that
    /// expectPlace leads to, the next at least; the answer is the same.
    [[nodiscard]] std::optional<Found> find(double radius, const ReleaseQuery& query,
                                            const std::function<void()>& lookAhead = {});
    /// The same, but for places that do not stay: those are given up, until one does. As no site is
    /// given up twice, this ends.
    [[nodiscard]] std::optional<Eigen::Vector3d>
    findLasting(double radius, const ReleaseQuery& query,
                const std::function<void()>& lookAhead = {});

    /// The draw after the last one taken, and further ones when called again, for a sphere of
    /// `radius`: each comes to a place, as far as is known. None when all ceilings are gone, or too
    /// many draws are expected. rewind() is to be called before the next search.
    [[nodiscard]] Draw* expectPlace(double radius);
    void rewind();
    /// Finds out what a draw leads to, and whether it suits. On any thread.
    void lookAhead(Draw& draw, const ReleaseQuery& query) const;

    /// Whether a single place is free now.
    [[nodiscard]] bool any();

    /// To be called for each sphere that has come to rest.
    void close(const Eigen::Vector3d& centre, double radius)
    {
        // Ceilings are few: whether something rests in one is looked up when it is drawn.
        if (sweeping_)
        {
            sites_.close(centre, radius);
        }
        ahead_.voidNear(centre, radius, draws_);
    }

    /// From now on, once there are no ceilings, free sites are taken at random and not in order.
    void scatter(bool scattered) { scattered_ = scattered; }

    /// Gives up the site of the last place found, from which no sphere came to rest.
    void giveUp();

private:
    /// How far from its site a place may be that stands for it.
    [[nodiscard]] double farthest() const { return 2 * sites_.halfDiagonal(); }
    /// What is known of a place so far from an open site.
    [[nodiscard]] Start startWithin(double way) const;
    void findCeilings(double band);
    void startSweep();
    [[nodiscard]] bool isTaken(std::size_t site) const;
    void dropCeiling(std::size_t index);
    [[nodiscard]] std::size_t ceilingOfDraw(std::uint64_t number) const;
    [[nodiscard]] Draw::Key key(std::uint64_t number, double radius) const
    {
        return {number, ceilings_[ceilingOfDraw(number)], radius};
    }
    void findOut(Draw& draw, const ReleaseQuery& query) const;
    void lookAtSite(Draw& draw) const;
    void findPlace(Draw& draw) const;
    const Draw& nextDraw(double radius, const ReleaseQuery& query,
                         const std::function<void()>& lookAhead);
    const Draw& take(const Draw& draw);
    [[nodiscard]] std::optional<Found> sweep(double radius, const ReleaseQuery& query);
    [[nodiscard]] std::size_t nextFree(std::size_t site, const ReleaseQuery& query);

    const World& world_;
    Threads& threads_;
    double radius_;
    SiteLattice sites_;
    /// Open sites with none above; the last window_ of them are in use, those before are lower.
    std::vector<std::uint32_t> ceilings_;
    std::size_t window_ = 0;
    std::size_t lastCeiling_ = 0; ///< index of the one drawn last
    bool scattered_ = false;
    bool sweeping_ = false;    ///< no ceilings are left, and taken sites are closed
    std::size_t sweep_ = 0;    ///< all sites before this one are closed
    std::size_t lastFree_ = 0; ///< the site found last in the sweep
    Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
    bool highOnly_ = true;            ///< only ceilings in the window are drawn
    std::uint64_t draws_ = 0;         ///< number of the last one taken
    std::uint64_t lastForgotten_ = 0; ///< the last after which a ceiling was forgotten
    Draw lone_;                       ///< of a search that does not look ahead
    Lookahead ahead_;

    // Since rewind().
    std::uint64_t expected_ = 0; ///< draws after the last one taken
    struct Passed
    {
        std::size_t index;
        std::uint32_t site;
        std::size_t window; ///< before it
    };
    std::vector<Passed> passed_; ///< ceilings that draws have ended that were expected
};

} // namespace frostfill
