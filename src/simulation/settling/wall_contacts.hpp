// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/contact/neighbour_list.hpp"
#include "simulation/settling/contact_law.hpp"
#include "simulation/settling/overlap_relief.hpp"
#include "simulation/world/world.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Walls that running spheres touch, and what those contacts know. A round wall of many triangles
/// touches a sphere in many places, whose normals differ by little. As one spring each they would
/// be as stiff as they are many, so those that push about the same way share one, by their depths.
class WallContacts
{
public:
    WallContacts(World& world, const RunningColumn<Eigen::Vector3d>& spin, const ContactLaw& law,
                 Threads& threads)
        : world_(world), running_(world.spheres.running()), spin_(spin), law_(law),
          threads_(threads), around_(running_)
    {
    }

    /// Which spheres may touch walls: see PairContacts::list.
    void list(std::span<const double> reaches);
    /// The law has become stiffer by a factor.
    void stiffen(double factor);
    /// See PairContacts::takeSprings.
    void takeSprings(bool takes);
    /// Contacts begin anew: nothing is held but by overlaps.
    void forget();
    void push(const ContactStep& step);
    /// Of spheres beside walls.
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(beside_.size()); }
    [[nodiscard]] std::uint32_t rowOf(std::uint32_t k) const { return beside_[k].row; }
    /// Calls visit(contact) for each wall of one of them with a gap below `gap` [r]. Contacts know
    /// what they knew.
    template <class Visit>
    void findNear(std::uint32_t k, double gap, Visit&& visit)
    {
        touch(beside_[k], gap);
        for (Wall& wall : beside_[k].walls)
        {
            visit(contactOf(beside_[k], wall));
        }
    }
    /// What all walls do to one of them from now on, in place of push().
    void store(std::uint32_t k, const SurfaceForce& sum) { beside_[k].force = sum; }
    /// All walls that were near a sphere at the last push().
    void addTo(OverlapRelief& relief);
    /// Of all walls on one sphere, since the last push().
    [[nodiscard]] const SurfaceForce& on(std::uint32_t row) const
    {
        static const SurfaceForce kNone;
        return placeOf_[row] == kNowhere ? kNone : beside_[placeOf_[row]].force;
    }
    /// How many walls push one sphere by more than `least` [m g]; of contacts that know forces.
    [[nodiscard]] int countOn(std::uint32_t row, double least) const;

    /// Calls visit(row, overlap) for each sphere in a wall, as of the last push() [r].
    template <class Visit>
    void forEachOverlap(Visit&& visit) const
    {
        for (const Beside& one : beside_)
        {
            for (const Wall& wall : one.walls)
            {
                if (wall.depth > 0)
                {
                    visit(one.row, wall.depth);
                }
            }
        }
    }
    [[nodiscard]] double energy() const; ///< in springs

private:
    static constexpr std::uint32_t kNowhere = 0xffffffff;
    struct Wall
    {
        Eigen::Vector3d normal;
        double depth;
        Spring spring;
        ContactMemory memory;
    };
    /// A sphere beside walls.
    struct Beside
    {
        std::uint32_t row;
        std::vector<Wall> walls;
        SurfaceForce force;
    };

    void pushOff(Beside& one, const ContactStep& step);
    void touch(Beside& one, double gap);
    [[nodiscard]] LoadedContact contactOf(const Beside& one, Wall& wall) const
    {
        const double stiffness = hasSprings_ ? wall.spring.stiffness : 0;
        return {one.row, LoadedContact::kWall, wall.normal, wall.depth, stiffness, &wall.memory};
    }
    [[nodiscard]] double reachOf(const Beside& one) const;
    void findWalls(std::uint32_t row, double gap, std::vector<Wall>& walls);
    static void passOn(const std::vector<Wall>& before, std::vector<Wall>& now);
    void shareSprings(double radius, double gap, std::vector<Wall>& walls) const;

    World& world_;
    RunningSpheres& running_;
    const RunningColumn<Eigen::Vector3d>& spin_;
    const ContactLaw& law_;
    Threads& threads_;
    RunningColumn<NeighbourList> around_;
    bool hasSprings_ = true;
    std::vector<Beside> beside_;         ///< ascending in row
    std::vector<std::uint32_t> placeOf_; ///< by row: in beside_, or kNowhere
};

} // namespace frostfill
