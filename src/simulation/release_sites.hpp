// SPDX-License-Identifier: MIT
#pragma once

#include <simulation/open_sites.hpp>
#include <simulation/world.hpp>

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
    /// others are used together with it; lower ones follow as those above fill up.
    ReleaseSites(const World& world, double radius, double band);

    /// A place that is clear of walls and of spheres at rest, and for which `suits(place)` holds.
    /// Places that do not suit now are left for later. Empty when there is none.
    template <class Suits>
    [[nodiscard]] std::optional<Eigen::Vector3d> find(Suits&& suits)
    {
        // Places that do not suit are taken for the moment only: so many misses mean that most are.
        for (const bool highOnly : {true, false})
        {
            const std::size_t patience = 64 + 2 * (highOnly ? window_ : ceilings_.size());
            for (std::size_t misses = 0; misses < patience && !ceilings_.empty(); ++misses)
            {
                const auto place = drawAtCeiling(highOnly ? window_ : ceilings_.size());
                if (place && suits(*place))
                {
                    return place;
                }
            }
        }
        if (!ceilings_.empty())
        {
            return std::nullopt;
        }
        sweep_ = sites_.nextOpen(sweep_);
        for (std::size_t site = nextFree(sweep_); site < sites_.lattice().size();
             site = nextFree(site + 1))
        {
            if (suits(place_))
            {
                lastFree_ = site;
                return place_;
            }
        }
        return std::nullopt;
    }

    /// Whether a single place is free now.
    [[nodiscard]] bool any()
    {
        return find([](const Eigen::Vector3d&) { return true; }).has_value();
    }

    /// To be called for each sphere that has come to rest.
    void close(const Eigen::Vector3d& centre, double radius) { sites_.close(centre, radius); }

    /// Gives up the site of the last place found, from which no sphere came to rest.
    void giveUp();

private:
    /// How far from its site a place may be that stands for it.
    [[nodiscard]] double farthest() const { return 2 * sites_.halfDiagonal(); }
    void findCeilings(double band);
    void dropCeiling(std::size_t index);
    [[nodiscard]] std::optional<Eigen::Vector3d> drawAtCeiling(std::size_t among);
    [[nodiscard]] std::size_t nextFree(std::size_t site);

    const World& world_;
    double radius_;
    OpenSites sites_;
    /// Open sites with none above; the last window_ of them are in use, those before are lower.
    std::vector<std::uint32_t> ceilings_;
    std::size_t window_ = 0;
    std::size_t lastCeiling_ = 0; ///< index of the one drawn last
    std::size_t sweep_ = 0;       ///< all sites before this one are closed
    std::size_t lastFree_ = 0;    ///< the site found last in the sweep
    Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
    std::uint64_t draws_ = 0;
};

} // namespace frostfill
