// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace frostfill
{

struct World;

/// What is watched of a running sphere, to tell when it comes to rest.
struct RestWatch
{
    Eigen::Vector3d start = Eigen::Vector3d::Zero(); ///< position at the window's start
    double age = 0; ///< since its release, or something came to rest beside it [sqrt(r/g)]
    std::uint32_t stillWindows = 0; ///< in a row in which it hardly moved
};

/// How far the newest set has come.
struct SetProgress
{
    std::size_t size = 0;    ///< spheres of a whole set
    std::size_t running = 0; ///< of all sets
    bool complete = false;   ///< as many have appeared as are to
    bool noRoom = false;     ///< the last search found none, and another is not due yet
    double ageLimit = 0;     ///< RestWatch::age after which a sphere is overdue [sqrt(r/g)]
};

/// A freezing rule: which of the calm spheres may be frozen, and so when others follow. Whatever it
/// says, a sphere is frozen only where something carries it, and one that is overdue wherever it
/// is.
class FreezingPart
{
public:
    virtual ~FreezingPart() = default;

    /// At the end of each window. Takes out of `sleepy` those that are to run on: rows of `running`
    /// whose spheres are calm or overdue, the lowest sphere first.
    virtual void select(const SetProgress& set, std::span<RestWatch> running,
                        std::vector<std::uint32_t>& sleepy) = 0;

    /// Whether spheres are to appear while others run.
    [[nodiscard]] virtual bool allowsRelease(const SetProgress& set) const = 0;
    /// They are looked for.
    virtual void moreAppear() {}

    /// Whether sets settle and freeze as a whole: what found no room is added to the newest set,
    /// and piles settle slowly and densely.
    [[nodiscard]] virtual bool keepsSets() const { return false; }
};

/// The one that the world's scene asks for.
[[nodiscard]] std::unique_ptr<FreezingPart> makeFreezing(const World& world);

} // namespace frostfill
