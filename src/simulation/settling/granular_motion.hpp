// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/settling/pair_contacts.hpp"
#include "simulation/settling/wall_contacts.hpp"

#include <vector>

namespace frostfill
{

/// How far from rest spheres are.
struct Unrest
{
    double missing = 0;     ///< [own weight] on a sphere, at most
    std::size_t moving = 0; ///< spheres on which kMissingOnMoving is missing
    double speed = 0;       ///< [sqrt(g r)] of the fastest
    double kinetic = 0;     ///< energy, with that of spin

    void add(const Unrest& other)
    {
        missing = std::max(missing, other.missing);
        moving += other.moving;
        speed = std::max(speed, other.speed);
        kinetic += other.kinetic;
    }
};

/// Moves all running spheres together, with spin, by forces of soft contacts, in small explicit
/// steps. The same bits on any number of threads.
class GranularMotion
{
public:
    /// World and threads outlive this.
    GranularMotion(World& world, const ContactLaw& law, Threads& threads);

    /// What a course does besides.
    struct Course
    {
        double hardening = 0; ///< see ContactStep
        double drag = 0;      ///< of all motion [1/sqrt(r/g)]
    };
    /// For a time [sqrt(r/g)], in steps that the stiffness allows.
    void advance(double time, const Course& course);
    /// All contacts become stiffer by a factor; friction holds what it held.
    void stiffen(double factor);
    /// To be called when there are other spheres, or they are elsewhere.
    void listAnew() { isListed_ = false; }

    /// As the last step found it.
    [[nodiscard]] const Unrest& unrest() const { return unrest_; }
    [[nodiscard]] double deepest() const { return std::max(pairs_.deepest(), walls_.deepest()); }
    /// Of motion, spin, height and springs.
    [[nodiscard]] double energy() const;
    [[nodiscard]] const Eigen::Vector3d& spin(std::uint32_t row) const { return spin_[row]; }
    void setSpin(std::uint32_t row, const Eigen::Vector3d& spin) { spin_[row] = spin; }

private:
    void list();
    void step(const ContactStep& step, double drag);
    [[nodiscard]] Unrest move(std::uint32_t row, double dt, double drag);

    World& world_;
    RunningSpheres& running_;
    Threads& threads_;
    ContactLaw law_;
    RunningColumn<Eigen::Vector3d> spin_;     ///< angular velocity
    RunningColumn<Eigen::Vector3d> listedAt_; ///< place when contacts were listed
    PairContacts pairs_;
    WallContacts walls_;
    bool isListed_ = false;
    /// Of some spheres each.
    struct Part
    {
        Unrest unrest;
        double squareMoved = 0; ///< since contacts were listed
    };
    std::vector<Part> parts_;
    Unrest unrest_;
};

} // namespace frostfill
