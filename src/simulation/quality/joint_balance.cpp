// SPDX-License-Identifier: MIT
#include "simulation/quality/joint_balance.hpp"

#include "base/random.hpp"
#include "simulation/quality/tolerances.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace frostfill
{
namespace
{

/// The normal force of the projection. Its slope is that of a sum of squares, of what is cut off:
/// linear between the two normal forces from which nothing is.
double normalForceOf(double along, double across, double roll, const ConeSlopes& slopes)
{
    for (const bool cutsForce : {false, true})
    {
        for (const bool cutsRoll : {false, true})
        {
            const double friction = cutsForce ? slopes.friction : 0;
            const double rolling = cutsRoll ? slopes.rolling : 0;
            const double found = (along + friction * across + rolling * roll) /
                                 (1 + friction * friction + rolling * rolling);
            if (cutsForce == (across > slopes.friction * found) &&
                cutsRoll == (roll > slopes.rolling * found))
            {
                return found;
            }
        }
    }
    return 0; // pushes the other way, or rounding decides
}

Eigen::Vector3d shortened(const Eigen::Vector3d& vector, double length, double most)
{
    return length > most ? Eigen::Vector3d(most / length * vector) : vector;
}

} // namespace

Eigen::Vector3d projectToCone(const Eigen::Vector3d& force, const Eigen::Vector3d& normal,
                              double friction)
{
    const double along = force.dot(normal);
    const Eigen::Vector3d across = force - along * normal;
    const double length = across.norm();
    if (along >= 0 && length <= friction * along)
    {
        return force;
    }
    const double onto = (along + friction * length) / (1 + friction * friction);
    if (onto <= 0)
    {
        return Eigen::Vector3d::Zero();
    }
    const double share = length > 0 ? friction * onto / length : 0;
    return onto * normal + share * across;
}

ContactLoad projectToCone(const ContactLoad& load, const Eigen::Vector3d& normal,
                          const ConeSlopes& slopes)
{
    const double along = load.force.dot(normal);
    const Eigen::Vector3d across = load.force - along * normal;
    const Eigen::Vector3d roll = load.roll - load.roll.dot(normal) * normal;
    const double acrossLength = across.norm();
    const double rollLength = roll.norm();
    const double onto = normalForceOf(along, acrossLength, rollLength, slopes);
    if (onto <= 0)
    {
        return {};
    }
    return {onto * normal + shortened(across, acrossLength, slopes.friction * onto),
            shortened(roll, rollLength, slopes.rolling * onto)};
}

namespace
{

constexpr std::size_t kTakenTogether = 256; // contacts or bodies that one thread takes in one go
constexpr double kInertia = 0.4;            // of a full sphere, over mass and square of the radius
constexpr int kPowerSteps = 30;             // of the power method, which needs no accuracy
constexpr double kSafety = 1.1;             // on what it finds from below

double massOf(const ContactNetwork::Body& body)
{
    return body.radius * body.radius * body.radius;
}

/// Whether forces leave far too many unbalanced, and hardly fewer than half the looks ago.
bool isHopeless(const std::vector<std::size_t>& looks, std::size_t except)
{
    const auto now = static_cast<double>(looks.back());
    return looks.size() >= kFewestLooks && now > kFarTooMany * static_cast<double>(except + 1) &&
           now > kHardlyFewer * static_cast<double>(looks[looks.size() / 2]);
}

} // namespace

JointBalance::JointBalance(const ContactNetwork& network, Threads& threads)
    : network_(network), threads_(threads),
      force_(network.contacts.size(), Eigen::Vector3d::Zero()), ahead_(force_), next_(force_),
      acceleration_(network.bodies.size(), Eigen::Vector3d::Zero()), spin_(acceleration_)
{
    if (network.rollingFriction > 0)
    {
        roll_ = rollAhead_ = rollNext_ = force_;
    }
    const auto& contacts = network.contacts;
    contactsOf_ = Buckets<std::uint32_t>(network.bodies.size(),
                                         [&](auto&& enter)
                                         {
                                             for (std::uint32_t k = 0; k < contacts.size(); ++k)
                                             {
                                                 enter(contacts[k].upon, 2 * k);
                                                 if (contacts[k].from != ContactNetwork::kWall)
                                                 {
                                                     enter(contacts[k].from, 2 * k + 1);
                                                 }
                                             }
                                         });
}

// Forces lie at the points of contact, so the torque on both bodies is the same but for the radius.
void JointBalance::accelerate(const Vectors& force, const Vectors& roll, bool pulled)
{
    forEachPart(threads_, network_.bodies.size(), kTakenTogether,
                [&](std::size_t first, std::size_t last, std::size_t)
                {
                    for (std::size_t body = first; body < last; ++body)
                    {
                        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
                        Eigen::Vector3d torque = Eigen::Vector3d::Zero();
                        for (const std::uint32_t end : contactsOf_[body])
                        {
                            const std::uint32_t contact = end / 2;
                            const Eigen::Vector3d& f = force[contact];
                            end % 2 == 0 ? sum += f : sum -= f;
                            torque -= network_.contacts[contact].normal.cross(f);
                            if (!roll.empty())
                            {
                                const Eigen::Vector3d m = armOver(body, contact) * roll[contact];
                                end % 2 == 0 ? torque += m : torque -= m;
                            }
                        }
                        const double mass = massOf(network_.bodies[body]);
                        acceleration_[body] = sum / mass;
                        if (pulled)
                        {
                            acceleration_[body] += network_.bodies[body].pull;
                        }
                        spin_[body] = torque / (kInertia * mass);
                    }
                });
}

// The acceleration of one surface against the other, at the point of contact.
Eigen::Vector3d JointBalance::approach(std::size_t contact) const
{
    const auto& [normal, upon, from] = network_.contacts[contact];
    if (from == ContactNetwork::kWall)
    {
        return acceleration_[upon] - spin_[upon].cross(normal);
    }
    return acceleration_[upon] - acceleration_[from] - (spin_[upon] + spin_[from]).cross(normal);
}

// How long the lever of a moment is on a body, over its radius.
double JointBalance::armOver(std::size_t body, std::size_t contact) const
{
    return network_.arm(contact) / network_.bodies[body].radius;
}

// The acceleration of one body's spin against the other's, times the arm.
Eigen::Vector3d JointBalance::rolling(std::size_t contact) const
{
    const auto& [normal, upon, from] = network_.contacts[contact];
    Eigen::Vector3d rolling = armOver(upon, contact) * spin_[upon];
    if (from != ContactNetwork::kWall)
    {
        rolling -= armOver(from, contact) * spin_[from];
    }
    return rolling - rolling.dot(normal) * normal;
}

// By how much a force in it accelerates its own surfaces. Without friction none turns.
// A moment accelerates spins by less.
double JointBalance::compliance(std::size_t contact) const
{
    const auto& [normal, upon, from] = network_.contacts[contact];
    double inverse = 1 / massOf(network_.bodies[upon]);
    if (from != ContactNetwork::kWall)
    {
        inverse += 1 / massOf(network_.bodies[from]);
    }
    return friction_ > 0 ? inverse * (1 + 1 / kInertia) : inverse;
}

// The largest eigenvalue of what forces do to each other, by the power method. It is 1 at least, as
// a force moves its own surfaces by its compliance. Forces begin at random: even ones would cancel
// out where walls face each other.
void JointBalance::findStiffness()
{
    const std::size_t count = network_.contacts.size();
    for (std::size_t k = 0; k < count; ++k)
    {
        const auto random = [k](std::uint64_t n) { return 0.5 + uniformRandom(0, k, n); };
        const Eigen::Vector3d& normal = network_.contacts[k].normal;
        next_[k] = random(0) * normal;
        if (friction_ > 0)
        {
            next_[k] += normal.cross(Eigen::Vector3d(random(1), random(2), random(3)));
        }
        if (!roll_.empty())
        {
            rollNext_[k] = normal.cross(Eigen::Vector3d(random(4), random(5), random(6)));
        }
    }
    for (int k = 0; k < kPowerSteps; ++k)
    {
        accelerate(next_, rollNext_, false);
        double before = 0;
        double after = 0;
        for (std::size_t contact = 0; contact < count; ++contact)
        {
            const double compliance = this->compliance(contact);
            const Eigen::Vector3d& normal = network_.contacts[contact].normal;
            Eigen::Vector3d change = approach(contact) / compliance;
            if (friction_ == 0)
            {
                change = change.dot(normal) * normal;
            }
            before += next_[contact].squaredNorm() * compliance;
            after += change.squaredNorm() * compliance;
            next_[contact] = change;
            if (!roll_.empty())
            {
                const Eigen::Vector3d turned = rolling(contact) / compliance;
                before += rollNext_[contact].squaredNorm() * compliance;
                after += turned.squaredNorm() * compliance;
                rollNext_[contact] = turned;
            }
        }
        stiffness_ = before > 0 ? std::max(1.0, std::sqrt(after / before)) : 1;
        for (Vectors* all : {&next_, &rollNext_})
        {
            for (Eigen::Vector3d& one : *all)
            {
                one /= stiffness_;
            }
        }
    }
    stiffness_ *= kSafety;
}

// By the slope, and back into the cone.
void JointBalance::descend(std::size_t k, Progress& progress)
{
    const double along = 1 / (compliance(k) * stiffness_);
    const Eigen::Vector3d& normal = network_.contacts[k].normal;
    const Eigen::Vector3d down = ahead_[k] - along * approach(k);
    double steep = 0;
    if (roll_.empty())
    {
        next_[k] = projectToCone(down, normal, friction_);
    }
    else
    {
        const ContactLoad load =
            projectToCone({down, rollAhead_[k] - along * rolling(k)}, normal, slopes());
        next_[k] = load.force;
        rollNext_[k] = load.roll;
        const Eigen::Vector3d slope = (rollAhead_[k] - rollNext_[k]) / along;
        progress.uphill += slope.dot(rollNext_[k] - roll_[k]);
        steep = slope.squaredNorm();
    }
    const Eigen::Vector3d slope = (ahead_[k] - next_[k]) / along;
    progress.uphill += slope.dot(next_[k] - force_[k]);
    progress.steepest = std::max({progress.steepest, slope.squaredNorm(), steep});
}

JointBalance::Progress JointBalance::step()
{
    std::vector<Progress> parts(network_.contacts.size() / kTakenTogether + 1);
    forEachPart(threads_, network_.contacts.size(), kTakenTogether,
                [&](std::size_t first, std::size_t last, std::size_t part)
                {
                    for (std::size_t k = first; k < last; ++k)
                    {
                        descend(k, parts[part]);
                    }
                });
    Progress all;
    for (const Progress& part : parts)
    {
        all.uphill += part.uphill;
        all.steepest = std::max(all.steepest, part.steepest);
    }
    all.steepest = std::sqrt(all.steepest);
    return all;
}

void JointBalance::moveOn(double momentum)
{
    forEachPart(threads_, force_.size(), kTakenTogether,
                [&](std::size_t first, std::size_t last, std::size_t)
                {
                    for (std::size_t k = first; k < last; ++k)
                    {
                        ahead_[k] = next_[k] + momentum * (next_[k] - force_[k]);
                        if (!roll_.empty())
                        {
                            rollAhead_[k] = rollNext_[k] + momentum * (rollNext_[k] - roll_[k]);
                        }
                    }
                });
    std::swap(force_, next_);
    std::swap(roll_, rollNext_);
}

Balance JointBalance::solve(double friction, const BalanceGoal& goal)
{
    const bool isKnown = friction_ >= 0 && (friction > 0) == (friction_ > 0);
    friction_ = friction;
    if (!isKnown && !force_.empty())
    {
        findStiffness();
    }
    for (std::size_t k = 0; k < force_.size(); ++k)
    {
        const Eigen::Vector3d& normal = network_.contacts[k].normal;
        if (roll_.empty())
        {
            force_[k] = projectToCone(force_[k], normal, friction);
            continue;
        }
        const ContactLoad load = projectToCone({force_[k], roll_[k]}, normal, slopes());
        force_[k] = load.force;
        roll_[k] = load.roll;
    }
    ahead_ = force_;
    rollAhead_ = roll_;
    double time = 1; // Nesterov's sequence
    Balance balance;
    std::vector<std::size_t> looks; // unbalanced spheres
    for (int k = 1; k <= kMostForceSteps && !balance.settled; ++k)
    {
        accelerate(ahead_, rollAhead_, true);
        const Progress progress = step();
        const double later = progress.uphill > 0 ? 1 : (1 + std::sqrt(1 + 4 * time * time)) / 2;
        moveOn(progress.uphill > 0 ? 0 : (time - 1) / later);
        time = later;
        if (k % kLookEvery == 0 || k == kMostForceSteps)
        {
            accelerate(force_, roll_, true);
            balance = look(goal);
            looks.push_back(balance.unbalanced);
            balance.settled = progress.steepest <= kSettledForces * goal.unbalance ||
                              (goal.ends && (balance.unbalanced <= goal.except ||
                                             isHopeless(looks, goal.except)));
        }
    }
    return balance;
}

double JointBalance::unbalance(std::uint32_t body) const
{
    return std::max(acceleration_[body].norm(), kInertia * spin_[body].norm());
}

Balance JointBalance::look(const BalanceGoal& goal) const
{
    Balance balance;
    for (std::uint32_t body = 0; body < network_.bodies.size(); ++body)
    {
        const double missing = unbalance(body);
        balance.unbalanced += missing > goal.unbalance ? 1 : 0;
        balance.largest = std::max(balance.largest, missing);
    }
    return balance;
}

} // namespace frostfill
