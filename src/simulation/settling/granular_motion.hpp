// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/settling/impulse_sweeps.hpp"
#include "simulation/settling/pair_contacts.hpp"
#include "simulation/settling/wall_contacts.hpp"

#include <limits>
#include <vector>

namespace frostfill
{

/// How far from rest spheres are.
struct Unrest
{
    double missing = 0;       ///< [own weight] on a sphere, at most
    std::size_t moving = 0;   ///< spheres on which kMissingOnMoving is missing
    std::size_t creeping = 0; ///< spheres on which kMissingOnCreeping is missing
    std::size_t loose = 0;    ///< spheres that begin to roll off what they stand on
    double speed = 0;         ///< [sqrt(g r)] of the fastest
    double overlap = 0;       ///< [r] the deepest
    double wallOverlap = 0;   ///< [r] the deepest with a wall
    double kinetic = 0;       ///< energy, with that of spin
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
        /// [sqrt(g r)] No sphere becomes faster.
        double fastest = std::numeric_limits<double>::infinity();
    };
    /// For a time [sqrt(r/g)], in steps that the stiffness allows.
    void advance(double time, const Course& course);
    /// The same by impulses, in longer steps: see ImpulseSweeps. Contacts give way as long as
    /// `givesWay`, by little. Next to no drag slows what is loose: spheres on fewer than three
    /// contacts, and those that move where few do.
    void advanceByImpulses(double time, const Course& course, bool givesWay);
    /// Whether contacts are springs from now on, which is what energy() counts; or know forces
    /// alone.
    void takeSprings(bool takes);
    /// All contacts become stiffer by a factor; friction holds what it held.
    void stiffen(double factor);
    /// All contacts begin anew, as in a program that knows only where spheres lie.
    void forget();
    /// From now on.
    void setFriction(double ofSpheres, double ofWalls)
    {
        law_.friction = ofSpheres;
        law_.wallFriction = ofWalls;
    }
    /// Takes overlaps away where spheres lie, and lets forces be: see OverlapRelief. Stops all
    /// motion. Leaves all as it was where no way out is near.
    void relieve();
    /// Lifts spheres out of places that are too narrow for them, into which others have pressed
    /// them while contacts were soft, to the nearest place above without a wall; all contacts begin
    /// anew. Returns whether there were any.
    [[nodiscard]] bool liftOutOfWalls();
    /// To be called when there are other spheres, or they are elsewhere.
    void listAnew();

    /// As all lie at the end of the last advance().
    [[nodiscard]] const Unrest& unrest() const { return unrest_; }
    /// Whether no more than kFewMove of all spheres move.
    [[nodiscard]] bool fewMove() const
    {
        return static_cast<double>(unrest_.moving) <=
               kFewMove * static_cast<double>(running_.size());
    }
    /// Of motion, spin, height and springs.
    [[nodiscard]] double energy() const;
    [[nodiscard]] const Eigen::Vector3d& spin(std::uint32_t row) const { return spin_[row]; }
    void setSpin(std::uint32_t row, const Eigen::Vector3d& spin) { spin_[row] = spin; }

private:
    [[nodiscard]] double slipsFrom() const { return kSlipsFrom * softest_ / law_.stiffness; }
    void list();
    void pushAll();
    void step(const ContactStep& step, const Course& course);
    void divide(double time, double longest, const auto& step);
    void stepByImpulses(const Course& course, double stiffness);
    void plan();
    [[nodiscard]] SurfaceForce forceOn(std::uint32_t row) const;
    [[nodiscard]] Eigen::Vector3d accelerationOf(std::uint32_t row, const SurfaceForce& sum) const;
    void moveAll(const Course& course, bool bySprings);
    void accelerate(std::uint32_t row, const Course& course);
    void slow(std::uint32_t row, double drag, double fastest);
    [[nodiscard]] bool move(std::uint32_t row);
    void turn(std::uint32_t row, double dt);
    [[nodiscard]] bool liftOutOfWalls(std::uint32_t row);
    void look();
    void lookAtHold(std::uint32_t row, double missing);

    World& world_;
    RunningSpheres& running_;
    Threads& threads_;
    ContactLaw law_;
    double softest_;                          ///< stiffness before contacts grew stiffer
    RunningColumn<Eigen::Vector3d> spin_;     ///< angular velocity
    RunningColumn<Eigen::Vector3d> listedAt_; ///< place when contacts were listed
    RunningColumn<double> reach_;             ///< [r] radius and margin when contacts were listed
    PairContacts pairs_;
    WallContacts walls_;
    OverlapRelief relief_;
    ImpulseSweeps sweeps_;
    bool knowsImpulses_ = false; ///< or the next step without springs has to find them all
    bool isListed_ = false;
    bool hasSprings_ = true;
    bool isPlanned_ = false;    ///< the order of sweeps
    std::vector<char> isLoose_; ///< by row: impulses move it next to without drag
    std::vector<char> isFar_;   ///< by part of the rows: one has left its margin
    bool didFewMove_ = false;   ///< at the last look; not since contacts begin anew
    double dt_ = 0;             ///< of the steps
    Unrest unrest_;
};

} // namespace frostfill
