// SPDX-License-Identifier: MIT
#include "simulation/settling/granular_motion.hpp"

#include <cmath>

namespace frostfill
{

GranularMotion::GranularMotion(World& world, const ContactLaw& law, Threads& threads)
    : world_(world), running_(world.spheres.running()), threads_(threads), law_(law),
      spin_(running_, [](std::uint32_t, Eigen::Vector3d& spin) { spin.setZero(); }),
      listedAt_(running_), pairs_(running_, spin_, law_, threads),
      walls_(world, spin_, law_, threads)
{
}

void GranularMotion::stiffen(double factor)
{
    law_.stiffness *= factor;
    pairs_.stiffen(factor);
    walls_.stiffen(factor);
}

// Mass over stiffness is least for the smallest sphere, as the square of its radius.
void GranularMotion::advance(double time, const Course& course)
{
    const double longest = kStepOfSettling * world_.radii.smallest() / std::sqrt(law_.stiffness);
    const auto steps = static_cast<std::size_t>(std::ceil(time / longest));
    for (std::size_t k = 0; k < steps; ++k)
    {
        step({time / static_cast<double>(steps), course.hardening}, course.drag);
    }
}

void GranularMotion::list()
{
    pairs_.list();
    walls_.list();
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        listedAt_[row] = running_.position[row];
    }
    parts_.resize((running_.size() + kSpheresTogether - 1) / kSpheresTogether);
    isListed_ = true;
}

void GranularMotion::step(const ContactStep& step, double drag)
{
    if (!isListed_)
    {
        list();
    }
    pairs_.push(step);
    walls_.push(step);
    forEachPart(threads_, running_.size(), kSpheresTogether,
                [&](std::size_t first, std::size_t last, std::size_t part)
                {
                    Part& sum = parts_[part];
                    sum = {};
                    for (auto row = static_cast<std::uint32_t>(first); row < last; ++row)
                    {
                        sum.unrest.add(move(row, step.dt, drag));
                        const double moved =
                            (running_.position[row] - listedAt_[row]).squaredNorm();
                        sum.squareMoved = std::max(sum.squareMoved, moved);
                    }
                });
    unrest_ = {};
    for (const Part& part : parts_)
    {
        unrest_.add(part.unrest);
        // Two that have come nearer by half of the margin: the other half is for what is held.
        isListed_ = isListed_ && part.squareMoved < kListMargin * kListMargin / 16;
    }
}

Unrest GranularMotion::move(std::uint32_t row, double dt, double drag)
{
    const double radius = running_.radius[row];
    const double mass = massOf(radius);
    SurfaceForce sum = pairs_.on(row);
    const SurfaceForce& walls = walls_.on(row);
    sum.force += walls.force;
    sum.torque += walls.torque + (sum.moment + walls.moment) / radius;
    Eigen::Vector3d& position = running_.position[row];
    Eigen::Vector3d& velocity = running_.velocity[row];
    const Eigen::Vector3d acceleration = sum.force / mass + world_.pull.at(position, {0, 0, 0});
    velocity = (1 - dt * drag) * (velocity + dt * acceleration);
    position += dt * velocity;
    spin_[row] = (1 - dt * drag) * (spin_[row] + dt / inertiaOverRadius(radius) * sum.torque);
    const double missing = acceleration.norm();
    const double squared = velocity.squaredNorm();
    return {missing, missing > kMissingOnMoving ? std::size_t{1} : 0, std::sqrt(squared),
            (mass * squared + inertiaOverRadius(radius) * radius * spin_[row].squaredNorm()) / 2};
}

double GranularMotion::energy() const
{
    double energy = unrest_.kinetic + pairs_.energy() + walls_.energy();
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        energy -= massOf(running_.radius[row]) * world_.pull.uniform.dot(running_.position[row]);
    }
    return energy;
}

} // namespace frostfill
