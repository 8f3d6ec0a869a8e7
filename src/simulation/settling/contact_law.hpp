// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/contact/contact.hpp"
#include "simulation/settling/tolerances.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace frostfill
{

/// The damping ratio with which a linear spring and dashpot that never pull leave this restitution:
/// sin p, where (pi - 2 p) tan p = -ln e [Schwager & Poschel 2007], in closed form. Below e^-2,
/// which is that of critical damping, it is 1.
[[nodiscard]] inline double dampingRatioFor(double restitution)
{
    constexpr int kBisections = 60;
    double low = 0;
    double high = std::numbers::pi / 2;
    for (int k = 0; k < kBisections; ++k)
    {
        const double angle = (low + high) / 2;
        const double leaves = std::exp(-(std::numbers::pi - 2 * angle) * std::tan(angle));
        (leaves > restitution ? low : high) = angle;
    }
    return std::sin(low);
}

/// Of all contacts. Lengths in r, stiffness in m g / r.
struct ContactLaw
{
    double stiffness = 0;    ///< of two spheres of radius 1
    double dampingRatio = 1; ///< damping over the critical one: see dampingRatioFor
    double friction = 0;     ///< Coulomb's, of two spheres
    double wallFriction = 0;
    double rollingFriction = 0; ///< of both
};

/// A linear spring and a dashpot beside it.
struct Spring
{
    double stiffness = 0;
    double damping = 0;

    /// `radius`: the harmonic mean of two, or that of a sphere at a wall: so overlaps are alike for
    /// large and small spheres under pressure. `mass` is the reduced one.
    Spring(const ContactLaw& law, double radius, double mass) : stiffness(law.stiffness * radius)
    {
        damping = 2 * law.dampingRatio * std::sqrt(stiffness * mass);
    }
    Spring() = default;

    /// One of several springs side by side, or as many of them.
    [[nodiscard]] Spring part(double share) const
    {
        Spring part;
        part.stiffness = share * stiffness;
        part.damping = share * damping;
        return part;
    }
};

/// What a contact knows from one step to the next. Without springs, the stretches are the forces
/// along the contact [m g].
struct ContactMemory
{
    Eigen::Vector3d slide = Eigen::Vector3d::Zero(); ///< [r] stretch of the spring along it
    Eigen::Vector3d roll = Eigen::Vector3d::Zero();  ///< [r] of the one against rolling
    double held = 0;                                 ///< [m g] normal force without an overlap

    /// Springs become stiffer by a factor; what friction holds stays.
    void stiffen(double factor)
    {
        slide /= factor;
        roll /= factor;
    }
    /// Springs of this stiffness, squeezed by `depth`, become forces; and the other way round.
    void takeForces(double stiffness, double depth)
    {
        held = std::max(0.0, held + stiffness * depth);
        slide *= -kTangentialStiffness * stiffness;
        roll *= -kTangentialStiffness * stiffness;
    }
    void takeSprings(double stiffness, double depth)
    {
        held = std::max(0.0, held - stiffness * depth);
        slide /= -kTangentialStiffness * stiffness;
        roll /= -kTangentialStiffness * stiffness;
    }
};

/// Where and how two surfaces meet.
struct Touch
{
    Eigen::Vector3d normal;   ///< towards the sphere that is pushed
    Eigen::Vector3d velocity; ///< of its surface against the other one
    Eigen::Vector3d rolling;  ///< the same of its rolling: see momentOf
    double depth;             ///< by which they overlap
};

/// What a step does to contacts.
struct ContactStep
{
    double dt = 0;
    /// [1/sqrt(r/g)] Rate at which an overlap turns into a force without one. In equilibrium none
    /// is left by the method of multipliers [Hestenes 1969] [Powell 1969], but a gap of up to
    /// kGapAtRest.
    double hardening = 0;
    /// [r] Where such a force is that of a larger overlap, spheres have too little room. Friction
    /// does not hold them, so that they slip out, and when all flows it is no more than that.
    double slipsFrom = std::numeric_limits<double>::infinity();
};

/// A spring and a dashpot along a surface that give way where they would be stronger than `most`.
[[nodiscard]] inline Eigen::Vector3d holdBack(const Spring& spring, double most, const Touch& touch,
                                              const Eigen::Vector3d& velocity, double dt,
                                              Eigen::Vector3d& stretch)
{
    const Eigen::Vector3d along = velocity - velocity.dot(touch.normal) * touch.normal;
    stretch += dt * along;
    stretch -= stretch.dot(touch.normal) * touch.normal;
    const double stiffness = kTangentialStiffness * spring.stiffness;
    Eigen::Vector3d force =
        -stiffness * stretch - std::sqrt(kTangentialStiffness) * spring.damping * along;
    const double squared = force.squaredNorm();
    if (squared > most * most)
    {
        force *= most / std::sqrt(squared);
        stretch = -force / stiffness;
    }
    return force;
}

/// A contact's normal force, which never pulls.
[[nodiscard]] inline double normalForce(const Spring& spring, const Touch& touch,
                                        const ContactStep& step, ContactMemory& memory)
{
    const double approach = touch.velocity.dot(touch.normal);
    const double push = spring.stiffness * touch.depth + memory.held - spring.damping * approach;
    if (step.hardening > 0 && (touch.depth > 0 || touch.depth < -kGapAtRest))
    {
        const double overlap = touch.depth + kGapAtRest;
        const double held = memory.held + step.dt * step.hardening * spring.stiffness * overlap;
        memory.held = std::clamp(held, 0.0, kMostOverSlipping * spring.stiffness * step.slipsFrom);
    }
    if (step.hardening == 0)
    {
        memory.held = std::min(memory.held, spring.stiffness * step.slipsFrom);
    }
    return std::max(0.0, push);
}

/// Energy in a contact's springs.
[[nodiscard]] inline double elasticEnergy(const Spring& spring, double depth,
                                          const ContactMemory& memory)
{
    const double squeezed = std::max(0.0, depth + memory.held / spring.stiffness);
    return spring.stiffness / 2 *
           (squeezed * squeezed +
            kTangentialStiffness * (memory.slide.squaredNorm() + memory.roll.squaredNorm()));
}

/// Moment of inertia of a full sphere over its radius. Units of the run.
[[nodiscard]] inline double inertiaOverRadius(double radius)
{
    return 0.4 * massOf(radius) * radius;
}

/// A force at a sphere's surface, and what turns the sphere.
struct SurfaceForce
{
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d torque = Eigen::Vector3d::Zero(); ///< over the radius, of the force
    Eigen::Vector3d moment = Eigen::Vector3d::Zero(); ///< of what resists rolling
};

/// The force of a contact and its torque, which is the same for both spheres but for the radius;
/// and the moment that resists rolling, at most the rolling friction times the normal force times
/// `arm` [Luding 2008]: the reduced radius.
[[nodiscard]] inline SurfaceForce forceOf(const Spring& spring, double friction,
                                          double rollingFriction, double arm, const Touch& touch,
                                          const ContactStep& step, ContactMemory& memory)
{
    const double push = normalForce(spring, touch, step, memory);
    SurfaceForce result;
    result.force = push * touch.normal;
    if (memory.held > spring.stiffness * step.slipsFrom)
    {
        memory.slide.setZero();
        memory.roll.setZero();
        return result;
    }
    if (friction > 0)
    {
        const Eigen::Vector3d hold =
            holdBack(spring, friction * push, touch, touch.velocity, step.dt, memory.slide);
        result.force += hold;
        result.torque = hold.cross(touch.normal);
    }
    if (rollingFriction > 0)
    {
        result.moment = arm * touch.normal.cross(holdBack(spring, rollingFriction * push, touch,
                                                          touch.rolling, step.dt, memory.roll));
    }
    return result;
}

} // namespace frostfill
