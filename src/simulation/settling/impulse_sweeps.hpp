// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/settling/pair_contacts.hpp"
#include "simulation/settling/wall_contacts.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// A time step of spheres that do not give way.
struct ImpulseStep
{
    double dt = 0;
    int sweeps = 0;
    /// [m g / r] of contacts of a sphere of radius 1, as implicit springs; 0: none gives way.
    double stiffness = 0;
    double most = 0; ///< [m g] no contact of a sphere of radius 1 pushes harder, as none can burst
};

/// Velocities of spheres that do not give way: each contact has an impulse in its friction cone
/// that leaves no approach beyond its gap [Moreau 1988] [Jean 1999]. Projected Gauss-Seidel sweeps,
/// from the impulses of the step before, up a pile and down again: so weight gets through a pile in
/// a few steps, for which springs take thousands.
///
/// Contacts lie in slabs side by side, each as wide as the longest contact. Every other slab
/// touches no sphere of the same turn, so those are swept at the same time, with the same bits on
/// any number of threads.
class ImpulseSweeps
{
public:
    /// All outlive this.
    ImpulseSweeps(RunningSpheres& running, RunningColumn<Eigen::Vector3d>& spin,
                  const ContactLaw& law, PairContacts& pairs, WallContacts& walls, Threads& threads)
        : running_(running), spin_(spin), law_(law), pairs_(pairs), walls_(walls), threads_(threads)
    {
    }

    /// To be called when contacts are listed anew. `width`: of a slab at least [r].
    void plan(double width);
    /// Turns velocities that would be without contacts into those with them. What contacts know,
    /// and the forces on spheres, are those of this step.
    void solve(const ImpulseStep& step);
    /// The forces that contacts know, as spheres lie now.
    void hold();

private:
    /// What sweeps read and write of a sphere, or of the walls, which stand still.
    struct Body
    {
        Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
        Eigen::Vector3d surface = Eigen::Vector3d::Zero(); ///< spin times radius
        double inverseMass = 0;
        double inverseRadius = 1;
    };
    struct Entry
    {
        std::uint32_t body = 0;
        std::uint32_t other = 0;
        Eigen::Vector3d normal; ///< towards `body`
        double leaves = 0;      ///< the least speed apart afterwards
        double gives = 0;       ///< speed together for each impulse [1/m]
        double yields = 0;      ///< impulse for each speed that is lacking [m]
        double bends = 0;       ///< speed along it for each impulse more than before [1/m]
        double slides = 0;      ///< the same along the contact, turning included
        double friction = 0;
        double most = 0;        ///< of `push`
        double push = 0;        ///< impulse
        Eigen::Vector3d along;  ///< impulse of friction
        Eigen::Vector3d before; ///< the same in the step before
    };
    struct Rolling
    {
        double arm;
        double inertia; ///< over the arm squared
        Eigen::Vector3d along;
    };
    struct Item
    {
        double height; ///< of its sphere
        std::uint32_t index;
        bool isWall;
        std::uint32_t entries; ///< how many it has: a sphere beside walls may have several
    };
    struct Slab
    {
        std::vector<Item> items; ///< from below
        std::vector<Entry> entries;
        std::vector<Rolling> rollings;        ///< with rolling friction, by entry
        std::vector<ContactMemory*> memories; ///< by entry
    };

    void forEachShared(std::size_t count, const auto& body);
    void forEverySlab(const auto& visit);
    void forOneThenOther(const auto& visit);
    void layOut(double width);
    void placeBodies();
    void load(Slab& slab, const ImpulseStep& step);
    void add(Slab& slab, const LoadedContact& contact, const ImpulseStep& step) const;
    void start(Slab& slab, std::uint32_t walls);
    void sweep(Slab& slab, bool isUpwards);
    void apply(const Entry& entry, const Eigen::Vector3d& impulse, const Eigen::Vector3d& along);
    void turn(const Entry& entry, const Rolling& rolling, const Eigen::Vector3d& along);
    void push(Entry& entry);
    void roll(const Entry& entry, Rolling& rolling);
    void store(Slab& slab, double dt);
    [[nodiscard]] SurfaceForce store(Slab& slab, std::size_t k, double dt) const;

    RunningSpheres& running_;
    RunningColumn<Eigen::Vector3d>& spin_;
    const ContactLaw& law_;
    PairContacts& pairs_;
    WallContacts& walls_;
    Threads& threads_;
    std::vector<Body> bodies_; ///< by row, then one by slab for its walls
    std::vector<Slab> slabs_;
};

} // namespace frostfill
