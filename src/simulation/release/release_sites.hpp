// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/release/site_lattice.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/world/world.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace frostfill
{

/// A random point below a ceiling, and where a sphere released there stays.
struct Draw
{
    std::uint64_t number = 0;
    std::uint32_t site = 0;
    double radius = 0;                               ///< of the sphere [r]
    bool isKnown = false;                            ///< The following is computed and up to date.
    bool isClear = false;                            ///< There is a clear place near the site.
    bool stays = false;                              ///< The sphere can stay at `place`.
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< after ReleaseQuery::prepare
    Eigen::AlignedBox3d seen = {}; ///< holds the centres of all spheres that change the result

    /// Whether this is the draw with that number, of that site for that radius.
    [[nodiscard]] bool is(std::uint64_t its, std::uint32_t itsSite, double itsRadius) const
    {
        return number == its && site == itsSite && radius == itsRadius;
    }
};

/// Finds one place after another at which a sphere of one radius can be released: first at random
/// below the object's ceilings, the highest first, then, once nothing fits there, everywhere else
/// that is still free, so that "full" means that no place is left.
///
/// Draws come in batches of kBatch. A ceiling at which nothing fits is removed at the end of the
/// batch, so the ceilings of all its draws are known from the start. Draws may be computed ahead on
/// all threads; a sphere that comes to rest in the box that a draw has seen makes the draw stale.
/// The results are those of one draw after another, whatever is computed ahead [Smith & Pleszkun
/// 1985].
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

    /// Returns a place for a sphere of the radius of these sites at most, clear of walls and of
    /// spheres at rest, where it can stay. Places that do not suit now are left for later, places
    /// where it cannot stay are given up. Empty when there is none. `computeAhead`, if given,
    /// computes draws that expect() returns, among them the next one; the answer is the same.
    [[nodiscard]] std::optional<Eigen::Vector3d>
    find(double radius, const ReleaseQuery& query, const std::function<void()>& computeAhead = {});

    /// Returns the draw for a sphere of `radius` that follows after `n` others; none when it is of
    /// another batch.
    [[nodiscard]] Draw* expect(std::uint64_t n, double radius);
    /// Computes the result of a draw, on any thread.
    void compute(Draw& draw, const ReleaseQuery& query) const;

    /// Whether a single place is free now.
    [[nodiscard]] bool any();

    /// To be called for each sphere that has come to rest.
    void close(const Eigen::Vector3d& centre, double radius);

    /// From now on, once there are no ceilings, free sites are taken at random and not in order.
    void scatter(bool scattered) { scattered_ = scattered; }

private:
    /// How far from its site a place may be that stands for it.
    [[nodiscard]] double farthest() const { return 2 * sites_.halfDiagonal(); }
    /// What is known of a place so far from an open site.
    [[nodiscard]] Start startWithin(double way) const;
    void findCeilings(double band);
    [[nodiscard]] std::size_t ceilingOf(std::uint64_t draw) const;
    [[nodiscard]] bool isTaken(std::size_t site) const;
    void computePlace(Draw& draw) const;
    [[nodiscard]] Draw nextDraw(double radius, const ReleaseQuery& query,
                                const std::function<void()>& computeAhead);
    void endDraw(const Draw& draw);
    void removeEnded();
    void startSweep();
    [[nodiscard]] std::optional<Eigen::Vector3d> sweep(double radius, const ReleaseQuery& query);
    [[nodiscard]] std::optional<Eigen::Vector3d> sweepFrom(std::size_t site, double radius,
                                                           const ReleaseQuery& query);

    const World& world_;
    Threads& threads_;
    double radius_;
    SiteLattice sites_;
    /// Open sites with none above; the last window_ of them are in use, those before are lower.
    std::vector<std::uint32_t> ceilings_;
    std::size_t window_ = 0;
    bool highOnly_ = true;           ///< only ceilings in the window are drawn
    std::vector<std::size_t> ended_; ///< ceilings at which nothing can be released any more
    std::uint64_t draws_ = 0;        ///< number of the last draw
    std::vector<Draw> batch_;        ///< [kBatch] by number; none before one is expected
    std::uint64_t lastExpected_ = 0; ///< number of the last draw that was expected
    bool scattered_ = false;
    bool sweeping_ = false; ///< no ceilings are left, and taken sites are closed
    std::size_t sweep_ = 0; ///< all sites before this one are closed
};

} // namespace frostfill
