// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/settling/contact_law.hpp"
#include "simulation/settling/overlap_relief.hpp"
#include "simulation/solver/broad_phase.hpp"
#include "simulation/world/running_spheres.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace frostfill
{

/// Pairs of running spheres that touch, or may before they are listed anew [Verlet 1967], and what
/// their contacts know.
class PairContacts
{
public:
    PairContacts(RunningSpheres& running, const RunningColumn<Eigen::Vector3d>& spin,
                 const ContactLaw& law, Threads& threads)
        : running_(running), spin_(spin), law_(law), threads_(threads),
          broadPhase_(running, threads, 0)
    {
    }

    /// `reaches`: radii by row, and as far as each may go until the next list. Pairs of the list
    /// before, of the same rows, keep what they know.
    void list(std::span<const double> reaches);
    /// The law has become stiffer by a factor.
    void stiffen(double factor);
    /// Whether springs push, and contacts know how far they are stretched. Otherwise contacts know
    /// their forces, and push() is not to be called.
    void takeSprings(bool takes);
    /// Contacts begin anew: nothing is held but by overlaps.
    void forget();
    void push(const ContactStep& step);
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(pairs_.size()); }
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> rowsOf(std::uint32_t k) const
    {
        return {pairs_[k].a, pairs_[k].b};
    }
    /// None where the gap is not below `gap` [r].
    [[nodiscard]] std::optional<LoadedContact> contact(std::uint32_t k, double gap);
    /// What a pair does from now on, in place of push(). The second: it does nothing, and knows
    /// nothing.
    void store(std::uint32_t k, const SurfaceForce& onB) { forces_[k] = onB; }
    void part(std::uint32_t k)
    {
        forces_[k] = {};
        memory_[k] = {};
    }
    /// All pairs that push, or are near enough to be pushed together by others.
    void addTo(OverlapRelief& relief);
    /// Of all pairs on one sphere, since the last push().
    [[nodiscard]] SurfaceForce on(std::uint32_t row) const;
    /// Of how many pairs that is more than `least` [m g].
    [[nodiscard]] int countOn(std::uint32_t row, double least) const;

    /// Calls visit(row, overlap) for both of each pair that overlaps, as spheres lie now [r].
    template <class Visit>
    void forEachOverlap(Visit&& visit) const
    {
        for (const auto& [a, b, spring] : pairs_)
        {
            const double apart = (running_.position[b] - running_.position[a]).norm();
            if (const double overlap = running_.radius[a] + running_.radius[b] - apart; overlap > 0)
            {
                visit(a, overlap);
                visit(b, overlap);
            }
        }
    }
    [[nodiscard]] double energy() const; ///< in springs

private:
    struct Pair
    {
        std::uint32_t a, b; ///< rows; a is below b
        Spring spring;
    };
    [[nodiscard]] Pair pairOf(std::uint32_t a, std::uint32_t b) const;
    void sortByRow();
    void pushApart(std::size_t k, const ContactStep& step);

    RunningSpheres& running_;
    const RunningColumn<Eigen::Vector3d>& spin_;
    const ContactLaw& law_;
    Threads& threads_;
    BroadPhase broadPhase_;
    bool hasSprings_ = true;
    // By pair, ascending in a, then in b.
    std::vector<Pair> pairs_;
    std::vector<ContactMemory> memory_;
    std::vector<SurfaceForce> forces_; ///< on b
    // By row.
    std::vector<std::uint32_t> firstPair_; ///< [#rows + 1] in pairs_: those whose a it is
    std::vector<std::uint32_t> firstEnd_;  ///< [#rows + 1] in ends_
    std::vector<std::uint32_t> ends_;      ///< the pair twice, plus 1 for its b
};

} // namespace frostfill
