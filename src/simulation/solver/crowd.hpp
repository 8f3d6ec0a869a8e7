// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/solver/broad_phase.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The runners that the solvers take in hand, one after another, the lowest first, and whom each
/// may touch. What a solver reads of a member lies beside what it reads of the next.
///
/// With several threads the crowd is cut into strips of equal numbers, side by side. Each strip is
/// taken by one thread in the same order, at the same time as the others; see Turns. A small crowd
/// mostly falls into clusters that do not touch one another. Then no cluster is cut, each strip
/// gets as much to do as the others, and no member waits for one of another strip.
class Crowd
{
public:
    /// One of the members that another may touch.
    struct Near
    {
        std::uint32_t slot : 30;
        std::uint32_t isLower : 1;   ///< its turn comes first
        std::uint32_t isForeign : 1; ///< of another strip
    };
    /// Members with neighbouring slots, in the order of their turns.
    struct Strip
    {
        std::uint32_t begin;
        std::uint32_t end;
    };

    Crowd(RunningSpheres& running, const BroadPhase& pairs, Threads& threads)
        : running_(running), pairs_(pairs), threads_(threads)
    {
    }

    /// All runners that are in a pair. `down`: direction of the pull. Members are known once the
    /// crowd is arranged and each strip has been enlisted.
    void gather(const Eigen::Vector3d& down);
    /// These only, by row, as if the others were not there.
    void gather(std::span<const std::uint32_t> rows, const Eigen::Vector3d& down);
    /// Whether it will be cut into strips.
    [[nodiscard]] bool isCut() const { return wantedStrips_ > 1; }
    // Then what is gathered is arranged: it is put in order, and its clusters are found if it will
    // be cut, maybe by another thread at the same time. Once both are done, it is cut. Each step
    // takes one thread, while others may do what does not concern the crowd.
    void order();
    void cluster();
    void cut();
    /// All of that.
    void arrange();
    /// Finds out where members of a strip are, and whom each may touch.
    void enlist(std::size_t strip);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(rows_.size()); }
    [[nodiscard]] std::span<const Strip> strips() const { return strips_; }
    /// Whether members of one strip may touch those of another.
    [[nodiscard]] bool stripsTouch() const { return stripsTouch_; }

    // By slot.
    [[nodiscard]] const Ball& operator[](std::uint32_t slot) const { return balls_[slot]; }
    [[nodiscard]] std::uint32_t row(std::uint32_t slot) const { return rows_[slot]; }
    /// In the order of the whole crowd.
    [[nodiscard]] std::uint32_t rank(std::uint32_t slot) const { return ranks_[slot]; }
    /// Those that it may touch, by ascending row.
    [[nodiscard]] std::span<const Near> near(std::uint32_t slot) const
    {
        return {nearby_.data() + firstNear_[slot], nearCount_[slot]};
    }
    /// Where its list begins in a list of all; of size(): at most how long that is.
    [[nodiscard]] std::size_t firstNear(std::uint32_t slot) const { return firstNear_[slot]; }
    /// Whether some of those are of another strip.
    [[nodiscard]] bool isShared(std::uint32_t slot) const { return isShared_[slot] != 0; }
    /// Its runner has been moved.
    void follow(std::uint32_t slot)
    {
        const Eigen::Vector3d& p = running_.position[rows_[slot]];
        balls_[slot] = {p.x(), p.y(), p.z(), balls_[slot].radius};
    }

    /// Calls body(k) for each strip, on a thread of its own.
    template <class Body>
    void forEachStrip(Body&& body) const
    {
        threads_.forEachAtOnce(strips_.size(), body);
    }
    /// Calls body(slot) for each member of a strip, in the order of their turns.
    template <class Body>
    void forEachMember(std::size_t strip, Body&& body) const
    {
        for (std::uint32_t slot = strips_[strip].begin; slot < strips_[strip].end; ++slot)
        {
            body(slot);
        }
    }
    [[nodiscard]] Threads& threads() const { return threads_; }

private:
    static constexpr std::uint32_t kNone = 0xffffffff;
    static constexpr std::uint32_t kLargestSlot = 0x3fffffff;

    void startGathering(const Eigen::Vector3d& down);
    void enter(std::uint32_t row);
    void endGathering();
    void cutIntoStrips();
    void cutByPlace();
    void dealClusters();
    [[nodiscard]] bool findClusters(std::size_t largest);
    void join(std::uint32_t a, std::uint32_t b);
    [[nodiscard]] std::uint32_t leadOf(std::uint32_t row);
    void giveSlots();

    RunningSpheres& running_;
    const BroadPhase& pairs_;
    Threads& threads_;
    struct Height
    {
        double height; ///< against the pull [r]
        std::uint32_t row;
        std::uint32_t strip;
    };
    Eigen::Vector3d down_ = {0, -1, 0};
    std::size_t wantedStrips_ = 1;
    std::vector<Height> order_;          ///< the lowest first
    std::vector<std::uint32_t> members_; ///< rows as gathered; order_ may be sorted meanwhile
    std::vector<std::uint32_t> lead_;    ///< by row: another one of its cluster, at last the first
    std::vector<std::uint32_t> inCluster_; ///< by row of its first: how many they are
    std::vector<std::uint32_t> load_; ///< by row of its first: pairs and members; then its strip
    std::vector<std::uint32_t> clusters_; ///< rows of their first
    bool stripsTouch_ = false;
    std::vector<double> borders_;     ///< between strips
    std::vector<double> sample_;      ///< of places along the axis of strips
    std::vector<std::uint32_t> next_; ///< by strip: the slot to be given next; or its load
    std::vector<Strip> strips_;
    std::vector<Ball> balls_;
    std::vector<std::uint32_t> rows_;
    std::vector<std::uint32_t> ranks_;
    std::vector<std::size_t> firstNear_;
    std::vector<std::uint32_t> nearCount_;
    std::vector<char> isShared_;
    std::vector<Near> nearby_;
    std::vector<std::uint32_t> slot_; ///< by row
};

} // namespace frostfill
