// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/release/site_lattice.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/world/world.hpp"

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
    ReleaseSites(const World& world, double radius, double band, Threads& threads);

    /// A place that is clear of walls and of spheres at rest, taken from there to `prepare(place)`,
    /// and for which `suits` then holds. Places that do not suit now are left for later. Empty when
    /// there is none. With `ahead`, what the next draws lead to is found out on all threads at
    /// once; `prepare` may then not change anything. The answer is the same. With `givesUp` a
    /// search everywhere ends after as many places that do not suit as one below the ceilings.
    template <class Prepare, class Suits>
    [[nodiscard]] std::optional<Eigen::Vector3d> find(Prepare&& prepare, Suits&& suits,
                                                      bool ahead = false, bool givesUp = false)
    {
        for (const bool highOnly : {true, false})
        {
            for (int misses = 0; misses < kMaxMisses && !ceilings_.empty();)
            {
                const std::size_t among = highOnly ? window_ : ceilings_.size();
                auto place = take(nextDraw(among, prepare, ahead), among);
                if (place && suits(*place))
                {
                    return place;
                }
                misses += place ? 1 : 0; // else a ceiling is forgotten, which ends by itself
            }
        }
        if (!ceilings_.empty())
        {
            return std::nullopt;
        }
        startSweep();
        sweep_ = sites_.nextOpen(sweep_);
        int misses = 0;
        for (std::size_t site = nextFree(sweep_);
             site < sites_.end() && (!givesUp || misses < kMaxMisses); site = nextFree(site + 1))
        {
            const Eigen::Vector3d place = prepare(place_);
            if (suits(place))
            {
                lastFree_ = site;
                return place;
            }
            ++misses;
        }
        return std::nullopt;
    }

    /// To be called when something has come to rest, or does not rest any more, since `find` looked
    /// ahead.
    void clearLookahead() { ahead_.clear(); }

    /// Whether a single place is free now.
    [[nodiscard]] bool any()
    {
        return find([](const Eigen::Vector3d& p) { return p; },
                    [](const Eigen::Vector3d&) { return true; })
            .has_value();
    }

    /// To be called for each sphere that has come to rest.
    void close(const Eigen::Vector3d& centre, double radius)
    {
        // Ceilings are few: whether something rests in one is looked up when it is drawn.
        if (sweeping_)
        {
            sites_.close(centre, radius);
        }
    }

    /// Gives up the site of the last place found, from which no sphere came to rest.
    void giveUp();

private:
    /// What a draw of a ceiling leads to: a place, or that there is none.
    struct Draw
    {
        std::uint64_t number;
        std::uint32_t site;
        std::optional<Eigen::Vector3d> place;
    };

    /// How far from its site a place may be that stands for it.
    [[nodiscard]] double farthest() const { return 2 * sites_.halfDiagonal(); }
    /// What is known of a place so far from an open site.
    [[nodiscard]] Start startWithin(double way) const;
    void findCeilings(double band);
    void startSweep();
    [[nodiscard]] bool isTaken(std::size_t site) const;
    void dropCeiling(std::size_t index);
    [[nodiscard]] std::size_t ceilingOfDraw(std::uint64_t number, std::size_t among) const;
    [[nodiscard]] std::optional<Eigen::Vector3d> placeOfDraw(std::uint64_t number,
                                                             std::uint32_t site) const;
    std::optional<Eigen::Vector3d> take(const Draw& draw, std::size_t among);

    template <class Prepare>
    [[nodiscard]] Draw outcome(std::uint64_t number, std::size_t among, Prepare&& prepare) const
    {
        Draw draw{number, ceilings_[ceilingOfDraw(number, among)], std::nullopt};
        if (const auto clear = placeOfDraw(number, draw.site))
        {
            draw.place = prepare(*clear);
        }
        return draw;
    }

    // What is known ahead of a draw holds as long as the same ceiling would be drawn.
    [[nodiscard]] const Draw* knownAhead(std::uint64_t number, std::size_t among) const
    {
        if (ahead_.empty() || number < ahead_.front().number || number > ahead_.back().number)
        {
            return nullptr;
        }
        const Draw& draw = ahead_[number - ahead_.front().number];
        return draw.site == ceilings_[ceilingOfDraw(number, among)] ? &draw : nullptr;
    }

    template <class Prepare>
    [[nodiscard]] Draw nextDraw(std::size_t among, Prepare&& prepare, bool ahead)
    {
        const std::uint64_t number = ++draws_;
        // A ceiling that is forgotten changes which ones are drawn next.
        if (!ahead || threads_.concurrency() == 1 || sinceForgotten_ < kDrawsAhead / 2)
        {
            return outcome(number, among, prepare);
        }
        if (knownAhead(number, among) == nullptr)
        {
            ahead_.resize(kDrawsAhead);
            threads_.forEach(kDrawsAhead, [&](std::size_t i)
                             { ahead_[i] = outcome(number + i, among, prepare); });
        }
        return *knownAhead(number, among);
    }
    [[nodiscard]] std::size_t nextFree(std::size_t site);

    const World& world_;
    Threads& threads_;
    double radius_;
    SiteLattice sites_;
    /// Open sites with none above; the last window_ of them are in use, those before are lower.
    std::vector<std::uint32_t> ceilings_;
    std::size_t window_ = 0;
    std::size_t lastCeiling_ = 0; ///< index of the one drawn last
    bool sweeping_ = false;       ///< no ceilings are left, and taken sites are closed
    std::size_t sweep_ = 0;       ///< all sites before this one are closed
    std::size_t lastFree_ = 0;    ///< the site found last in the sweep
    Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
    std::uint64_t draws_ = 0;
    std::size_t sinceForgotten_ = 0; ///< draws, since one after which a ceiling was forgotten
    std::vector<Draw> ahead_;        ///< by number, without gaps
};

} // namespace frostfill
