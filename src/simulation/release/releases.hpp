// SPDX-License-Identifier: MIT
// Room: where and when spheres appear. It finds release sites that are clear, and adds the
// spheres of a set to the world.
#pragma once

#include "simulation/release/release_sites.hpp"

#include <optional>
#include <vector>

namespace frostfill
{

/// What appears next: a radius drawn from the run's distribution, and a place for it. The radii are
/// sorted into a few classes; each class has sites of its own, at which its largest radius fits. As
/// an object only fills up, a class for which no place is left is done with: from then on radii are
/// drawn from what is below it. So "full" means that not even the smallest radius finds a place.
class Releases
{
public:
    struct Found
    {
        Eigen::Vector3d place;
        double radius;
    };

    /// `world` and `threads` outlive this. `band`: see ReleaseSites.
    Releases(const World& world, double band, Threads& threads);

    /// The next sphere, at a place that is taken to `prepare(place, radius)` and for which
    /// `suits(place, radius)` then holds. Empty when there is none now. See ReleaseSites::find.
    template <class Prepare, class Suits>
    [[nodiscard]] std::optional<Found> find(Prepare&& prepare, Suits&& suits, bool ahead = false)
    {
        while (!classes_.empty())
        {
            if (!drawn_)
            {
                draw();
            }
            const double radius = *drawn_;
            if (const auto place = find(radius, prepare, suits, ahead))
            {
                drawn_.reset();
                return Found{*place, radius};
            }
            if (classes_.size() == 1 || classes_[lastClass_].sites.any())
            {
                return std::nullopt;
            }
            dropClasses(std::max<std::size_t>(1, lastClass_));
        }
        return std::nullopt;
    }

    /// The same for any clear place.
    template <class Suits>
    [[nodiscard]] std::optional<Found> find(Suits&& suits)
    {
        return find(asItIs, suits);
    }

    /// A place for a sphere of this radius.
    template <class Suits>
    [[nodiscard]] std::optional<Eigen::Vector3d> find(double radius, Suits&& suits)
    {
        return find(radius, asItIs, suits, false);
    }

    /// Before the first search with `ahead` after something has come to rest.
    void forgetAhead() { classes_.front().sites.forgetAhead(); }

    /// Whether a single place is free now, for the smallest radius.
    [[nodiscard]] bool any() { return classes_.front().sites.any(); }

    /// To be called for each sphere that has come to rest.
    void close(const Eigen::Vector3d& centre, double radius);

    /// Gives up the site of the last place found, from which no sphere came to rest.
    void giveUp() { classes_[lastClass_].sites.giveUp(); }

private:
    struct Class
    {
        double largest; ///< radius, for which its sites are
        ReleaseSites sites;
    };
    static Eigen::Vector3d asItIs(const Eigen::Vector3d& place, double) { return place; }
    void draw();

    template <class Prepare, class Suits>
    [[nodiscard]] std::optional<Eigen::Vector3d> find(double radius, Prepare&& prepare,
                                                      Suits&& suits, bool ahead)
    {
        if (radius > classes_.back().largest)
        {
            return std::nullopt;
        }
        lastClass_ = classOf(radius);
        // A draw that is known ahead is so for one radius.
        return classes_[lastClass_].sites.find(
            [&](const Eigen::Vector3d& place) { return prepare(place, radius); },
            [&](const Eigen::Vector3d& place) { return suits(place, radius); },
            ahead && world_.radii.equal());
    }

    void dropClasses(std::size_t from);
    [[nodiscard]] std::size_t classOf(double radius) const;

    const World& world_;
    std::vector<Class> classes_; ///< ascending; those that are done with are gone, but the first
    std::size_t lastClass_ = 0;
    std::optional<double> drawn_; ///< the next radius, for which there was no place yet
    std::uint64_t draws_ = 0;
};

} // namespace frostfill
