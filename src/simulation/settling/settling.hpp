// SPDX-License-Identifier: MIT
// Room: all spheres at once, with spin and friction, until they rest together: the discrete element
// method [Cundall & Strack 1979].
#pragma once

#include "base/threads.hpp"
#include "bulk/bulk.hpp"
#include "simulation/settling/granular_motion.hpp"
#include "simulation/world/world.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace frostfill
{

/// Lets all spheres at rest run again at once, under the friction of the scene, until they rest
/// together; then they freeze again.
///
/// With friction, those of one size settle by impulses: see ImpulseSweeps. Contacts give way by
/// little until next to nobody moves. Then overlaps are taken away.
///
/// With little friction or several sizes, or where that does not come to rest, they move as soft
/// spheres do that have weight and spin. When few still move, drag calms them, and every contact
/// hardens: its overlap goes into a force that needs none. Once forces balance, what is left of
/// overlaps is taken away. What does not balance for long, as a pile without friction, grows
/// stiffer besides. In the end spheres that carry each other are at most kGapAtRest apart.
///
/// Where the scene asks for a packing fraction of the bulk, all first flow without friction, and so
/// grow denser, until the fraction is there; friction then stops them. What is missing of it by
/// then is made good in another round.
///
/// Contacts keep their forces when all freezes. If the object is filled up in between and all runs
/// again, only what is new disturbs the rest.
class Settling
{
public:
    /// Both outlive this.
    Settling(World& world, Threads& threads);

    /// All at rest run again.
    void wakeAll();
    /// Spheres have appeared.
    void admit();
    /// They move for a time [sqrt(r/g)], with a drag [1/sqrt(r/g)].
    void flowFor(double time, double drag = 0);
    /// Whether few of all move.
    [[nodiscard]] bool isCalm() const;
    [[nodiscard]] const Unrest& unrest() const { return motion_.unrest(); }

    /// All that run begin to settle.
    void begin();
    /// Some time. Returns whether it is over: all have come to rest, or have been moving for too
    /// long, and are frozen.
    [[nodiscard]] bool step();

private:
    enum class Phase
    {
        compacts,
        stacks,
        flows,
        hardens,
    };
    void wakeInOrder(std::size_t first);
    void advance(double time, const GranularMotion::Course& course);
    void countStep(double time);
    void compact();
    void startRest();
    void advanceByImpulses(double time, double drag);
    [[nodiscard]] bool stack();
    [[nodiscard]] bool isStacked() const;
    [[nodiscard]] bool end();
    void startFlow();
    void flow();
    bool harden();
    [[nodiscard]] bool balances() const;
    [[nodiscard]] double mostMoving() const;
    [[nodiscard]] bool rests() const;
    [[nodiscard]] bool canBeRelieved() const;
    [[nodiscard]] bool isPinched() const;
    [[nodiscard]] bool isOfOneSize() const;
    [[nodiscard]] bool standsAnew();
    [[nodiscard]] bool hasStayed() const;
    void freeze();
    [[nodiscard]] double missingFraction();
    [[nodiscard]] double missingOfMeasured() const;
    [[nodiscard]] bool hasCompacted();
    void report();

    World& world_;
    RunningSpheres& running_;
    GranularMotion motion_;
    std::vector<std::uint32_t> order_; ///< ids, by the row in which each of them runs
    Phase phase_ = Phase::flows;
    bool givesWay_ = true;                  ///< contacts, while impulses settle the pile
    double inPhase_ = 0;                    ///< time since it began
    double stiffened_ = 1;                  ///< by this factor
    double mass_ = 0;                       ///< of all
    std::optional<Bulk> bulk_;              ///< if the scene asks for a packing fraction
    int compactions_ = 0;                   ///< since all began to run
    int reloads_ = 0;                       ///< times that forces were forgotten, of these spheres
    std::vector<Eigen::Vector3d> restedAt_; ///< by row, when they were last
    bool isDensest_ = false;                ///< without friction it had come to rest
};

} // namespace frostfill
