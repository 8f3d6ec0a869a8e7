// SPDX-License-Identifier: MIT
#pragma once

#include "base/buckets.hpp"
#include "base/threads.hpp"
#include "simulation/quality/contact_network.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace frostfill
{

/// The nearest force whose tangential part is at most `friction` times its normal one.
[[nodiscard]] Eigen::Vector3d projectToCone(const Eigen::Vector3d& force,
                                            const Eigen::Vector3d& normal, double friction);

/// What a contact can do: a force, and what resists rolling, a moment over the contact's arm.
struct ContactLoad
{
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d roll = Eigen::Vector3d::Zero();
};

/// How far both go, over the normal force.
struct ConeSlopes
{
    double friction = 0;
    double rolling = 0;
};

/// The nearest load whose normal force pushes, whose tangential force is at most the friction times
/// it, and whose moment lies across the normal and is at most the rolling friction times it.
[[nodiscard]] ContactLoad projectToCone(const ContactLoad& load, const Eigen::Vector3d& normal,
                                        const ConeSlopes& slopes);

/// When forces are good enough.
struct BalanceGoal
{
    double unbalance = 0;   ///< [own weight] that may be missing on a sphere
    std::size_t except = 0; ///< so many spheres may miss more
    bool ends = false;      ///< once that is reached; otherwise forces go on getting better
};

/// How well the forces of all contacts together hold the spheres.
struct Balance
{
    std::size_t unbalanced = 0; ///< spheres that miss more than the goal allows
    double largest = 0;         ///< [own weight] that is missing on a sphere
    bool settled = false;       ///< the forces are good enough, or are not worth another step
};

/// Looks for forces in all contacts of a packing at once that hold every sphere: normal forces push
/// and never pull, tangential ones are at most the friction times as large (Coulomb's cone), and on
/// each sphere forces and torques add up to none. If the network has rolling friction, moments
/// resist rolling, at most as it allows [Luding 2008]. Nothing is known of how the packing came to
/// be, so what stands here can stand. What does not stand cannot, but for forces that had not
/// settled.
///
/// Where they cannot hold all, what is missing is as little as can be, summed up over squares of
/// accelerations times masses. Without friction these are the accelerations with which the spheres
/// then begin to move: the principle of least constraint [Gauss 1829].
///
/// Convex, in three unknowns a contact; solved by projected gradients with momentum [Nesterov
/// 1983], which is dropped where it leads uphill [O'Donoghue & Candes 2015], as for granular matter
/// in [Mazhar et al. 2015]. A step costs some 40 ns a contact; steps grow with the height of the
/// pile.
class JointBalance
{
public:
    /// Both outlive this.
    JointBalance(const ContactNetwork& network, Threads& threads);

    /// Begins with the forces of the last call.
    Balance solve(double friction, const BalanceGoal& goal);

    /// What is missing on a body since the last call [own weight]: of the force, or of the torque
    /// over its radius, whichever is more.
    [[nodiscard]] double unbalance(std::uint32_t body) const;

    /// The force in a contact since the last call, on the body that it pushes. Units of the run, a
    /// mass being the cube of a radius.
    [[nodiscard]] const Eigen::Vector3d& force(std::size_t contact) const
    {
        return force_[contact];
    }
    /// The moment that resists rolling in it, on the body that it pushes, and against it on the
    /// other one. For networks with rolling friction.
    [[nodiscard]] Eigen::Vector3d moment(std::size_t contact) const
    {
        return network_.arm(contact) * roll_[contact];
    }

private:
    using Vectors = std::vector<Eigen::Vector3d>;
    /// What steps of some contacts come to.
    struct Progress
    {
        double uphill = 0;   ///< above 0: the momentum leads uphill
        double steepest = 0; ///< change of an acceleration
    };

    void accelerate(const Vectors& force, const Vectors& roll, bool pulled);
    [[nodiscard]] double armOver(std::size_t body, std::size_t contact) const;
    [[nodiscard]] Eigen::Vector3d rolling(std::size_t contact) const;
    [[nodiscard]] ConeSlopes slopes() const { return {friction_, network_.rollingFriction}; }
    void descend(std::size_t contact, Progress& progress);
    [[nodiscard]] Eigen::Vector3d approach(std::size_t contact) const;
    [[nodiscard]] double compliance(std::size_t contact) const;
    void findStiffness();
    Progress step();
    void moveOn(double momentum);
    [[nodiscard]] Balance look(const BalanceGoal& goal) const;

    const ContactNetwork& network_;
    Threads& threads_;
    double friction_ = std::numeric_limits<double>::quiet_NaN();
    double stiffness_ = 1; ///< the steepest slope of a step, for contacts of compliance 1

    // By contact.
    Vectors force_;
    Vectors ahead_; ///< forces, with their momentum
    Vectors next_;
    // Moments against rolling, over the arm; none of them without rolling friction.
    Vectors roll_;
    Vectors rollAhead_;
    Vectors rollNext_;
    // By body.
    Buckets<std::uint32_t> contactsOf_; ///< the contact twice, plus 1 for the one that pushes
    Vectors acceleration_;
    Vectors spin_; ///< angular acceleration times radius
};

} // namespace frostfill
