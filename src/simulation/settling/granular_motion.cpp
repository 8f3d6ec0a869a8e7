// SPDX-License-Identifier: MIT
#include "simulation/settling/granular_motion.hpp"

#include "simulation/contact/depenetration.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frostfill
{

GranularMotion::GranularMotion(World& world, const ContactLaw& law, Threads& threads)
    : world_(world), running_(world.spheres.running()), threads_(threads), law_(law),
      softest_(law.stiffness),
      spin_(running_, [](std::uint32_t, Eigen::Vector3d& spin) { spin.setZero(); }),
      listedAt_(running_), reach_(running_), pairs_(running_, spin_, law_, threads),
      walls_(world, spin_, law_, threads), sweeps_(running_, spin_, law_, pairs_, walls_, threads)
{
    listAnew();
}

void GranularMotion::listAnew()
{
    isListed_ = false;
    isLoose_.assign(running_.size(), 0);
}

void GranularMotion::stiffen(double factor)
{
    law_.stiffness *= factor;
    pairs_.stiffen(factor);
    walls_.stiffen(factor);
}

void GranularMotion::forget()
{
    pairs_.forget();
    walls_.forget();
    knowsImpulses_ = false;
    didFewMove_ = false;
    listAnew();
}

// Mass over stiffness is least for the smallest sphere, as the square of its radius.
void GranularMotion::advance(double time, const Course& course)
{
    takeSprings(true);
    divide(time, kStepOfSettling * world_.radii.smallest() / std::sqrt(law_.stiffness),
           [&] {
               step({dt_, course.hardening, slipsFrom()}, course);
           });
    knowsImpulses_ = true;
    look();
}

void GranularMotion::advanceByImpulses(double time, const Course& course, bool givesWay)
{
    takeSprings(false);
    const double step = didFewMove_ ? kStepOfFew : kStepOfImpulses;
    divide(time, step * std::sqrt(world_.radii.smallest()),
           [&] { stepByImpulses(course, givesWay ? kStiffnessOfImpulses * softest_ : 0); });
    look();
}

void GranularMotion::stepByImpulses(const Course& course, double stiffness)
{
    if (!isListed_)
    {
        list();
    }
    plan();
    threads_.forEach(
        running_.size(),
        [&](std::size_t k)
        {
            const auto row = static_cast<std::uint32_t>(k);
            running_.velocity[row] += dt_ * world_.pull.at(running_.position[row], {0, 0, 0});
        });
    sweeps_.solve({dt_, knowsImpulses_ ? kSweepsOfImpulses : kSweepsAtFirst, stiffness,
                   kSlipsFrom * softest_});
    knowsImpulses_ = true;
    moveAll(course, false);
}

void GranularMotion::takeSprings(bool takes)
{
    hasSprings_ = takes;
    pairs_.takeSprings(takes);
    walls_.takeSprings(takes);
}

void GranularMotion::plan()
{
    if (!isPlanned_)
    {
        const auto reaches = reach_.all();
        sweeps_.plan(2 * *std::max_element(reaches.begin(), reaches.end()));
        isPlanned_ = true;
    }
}

// Into equal steps, of which one at least is made: it lists what the look asks for.
void GranularMotion::divide(double time, double longest, const auto& step)
{
    const auto steps = static_cast<std::size_t>(std::ceil(time / longest));
    dt_ = time / static_cast<double>(steps);
    for (std::size_t k = 0; k < steps && (k == 0 || !world_.stop.isAsked()); ++k)
    {
        step();
    }
}

void GranularMotion::relieve()
{
    pushAll();
    relief_.clear();
    pairs_.addTo(relief_);
    walls_.addTo(relief_);
    std::vector<double> inverseMass;
    for (const double radius : running_.radius.all())
    {
        inverseMass.push_back(1 / massOf(radius));
    }
    if (!relief_.solve(inverseMass))
    {
        return;
    }
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        running_.position[row] += relief_.displacement(row);
        running_.velocity[row].setZero();
        spin_[row].setZero();
    }
    pushAll();
    look();
}

bool GranularMotion::liftOutOfWalls()
{
    bool anyLifted = false;
    walls_.forEachOverlap(
        [&](std::uint32_t row, double overlap)
        { anyLifted = (overlap > kOverlapRelieved && liftOutOfWalls(row)) || anyLifted; });
    if (anyLifted)
    {
        forget();
    }
    return anyLifted;
}

bool GranularMotion::liftOutOfWalls(std::uint32_t row)
{
    const double radius = running_.radius[row];
    const Eigen::Vector3d start = running_.position[row];
    const Eigen::Vector3d step = -kStepOfLift * radius * world_.pull.direction(start);
    for (int steps = 1; steps <= kStepsOfLift; ++steps)
    {
        Eigen::Vector3d place = start + steps * step;
        if (depenetrate(world_, place, radius, step.norm()))
        {
            running_.position[row] = place;
            running_.velocity[row].setZero();
            spin_[row].setZero();
            return true;
        }
    }
    return false;
}

// As spheres lie now.
void GranularMotion::pushAll()
{
    list();
    if (hasSprings_)
    {
        pairs_.push({});
        walls_.push({});
        return;
    }
    plan();
    sweeps_.hold();
}

// What is fast has a wider margin, so that lists are good for some steps.
void GranularMotion::list()
{
    if (world_.scene.rest.orientation)
    {
        world_.orientations.resize(world_.spheres.size(), Eigen::Quaterniond::Identity());
    }
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        listedAt_[row] = running_.position[row];
        const double ahead = kStepsListed * dt_ * running_.velocity[row].norm();
        reach_[row] = running_.radius[row] + kListMargin / 2 + std::min(kMostListedAhead, ahead);
    }
    pairs_.list(reach_.all());
    walls_.list(reach_.all());
    isListed_ = true;
    isPlanned_ = false;
    isFar_.resize((running_.size() + kSpheresTogether - 1) / kSpheresTogether);
}

void GranularMotion::step(const ContactStep& step, const Course& course)
{
    if (!isListed_)
    {
        list();
    }
    pairs_.push(step);
    walls_.push(step);
    moveAll(course, true);
}

// Springs accelerate them before; impulses have done so.
void GranularMotion::moveAll(const Course& course, bool bySprings)
{
    forEachPart(threads_, running_.size(), kSpheresTogether,
                [&](std::size_t first, std::size_t last, std::size_t part)
                {
                    char isFar = 0;
                    for (std::size_t k = first; k < last; ++k)
                    {
                        const auto row = static_cast<std::uint32_t>(k);
                        bySprings ? accelerate(row, course)
                                  : slow(row, isLoose_[row] != 0 ? kDragOfLoose : course.drag,
                                         course.fastest);
                        isFar |= static_cast<char>(move(row));
                    }
                    isFar_[part] = isFar;
                });
    isListed_ = std::count(isFar_.begin(), isFar_.end(), 1) == 0;
}

SurfaceForce GranularMotion::forceOn(std::uint32_t row) const
{
    SurfaceForce sum = pairs_.on(row);
    const SurfaceForce& walls = walls_.on(row);
    sum.force += walls.force;
    sum.torque += walls.torque;
    sum.moment += walls.moment;
    return sum;
}

Eigen::Vector3d GranularMotion::accelerationOf(std::uint32_t row, const SurfaceForce& sum) const
{
    return sum.force / massOf(running_.radius[row]) +
           world_.pull.at(running_.position[row], {0, 0, 0});
}

void GranularMotion::accelerate(std::uint32_t row, const Course& course)
{
    const SurfaceForce sum = forceOn(row);
    const double radius = running_.radius[row];
    running_.velocity[row] += dt_ * accelerationOf(row, sum);
    spin_[row] += dt_ / inertiaOverRadius(radius) * (sum.torque + sum.moment / radius);
    slow(row, course.drag, course.fastest);
}

void GranularMotion::slow(std::uint32_t row, double drag, double fastest)
{
    const double keeps = 1 - dt_ * drag;
    Eigen::Vector3d& velocity = running_.velocity[row];
    velocity *= keeps;
    spin_[row] *= keeps;
    if (velocity.squaredNorm() > fastest * fastest)
    {
        velocity *= fastest / velocity.norm();
    }
}

// Returns whether it has left its margin but for the quarter that is for what is held.
bool GranularMotion::move(std::uint32_t row)
{
    Eigen::Vector3d& position = running_.position[row];
    position += dt_ * running_.velocity[row];
    if (!world_.orientations.empty())
    {
        turn(row, dt_);
    }
    const double margin = reach_[row] - running_.radius[row] - kListMargin / 4;
    return (position - listedAt_[row]).squaredNorm() >= margin * margin;
}

// By the angle and about the axis of the spin, so that a quaternion stays one.
void GranularMotion::turn(std::uint32_t row, double dt)
{
    const double rate = spin_[row].norm();
    if (rate > 0)
    {
        Eigen::Quaterniond& orientation = world_.orientations[running_.id[row]];
        const Eigen::AngleAxisd turned(rate * dt, spin_[row] / rate);
        orientation = (turned * orientation).normalized();
    }
}

void GranularMotion::look()
{
    unrest_ = {};
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        const double radius = running_.radius[row];
        const double missing = accelerationOf(row, forceOn(row)).norm();
        const double squared = running_.velocity[row].squaredNorm();
        unrest_.missing = std::max(unrest_.missing, missing);
        unrest_.moving += missing > kMissingOnMoving ? 1 : 0;
        unrest_.creeping += missing > kMissingOnCreeping ? 1 : 0;
        unrest_.speed = std::max(unrest_.speed, std::sqrt(squared));
        unrest_.kinetic += (massOf(radius) * squared +
                            inertiaOverRadius(radius) * radius * spin_[row].squaredNorm()) /
                           2;
        if (!hasSprings_)
        {
            lookAtHold(row, missing);
        }
    }
    didFewMove_ = fewMove();
    const auto enter = [&](std::uint32_t, double overlap)
    { unrest_.overlap = std::max(unrest_.overlap, overlap); };
    walls_.forEachOverlap(enter);
    unrest_.wallOverlap = unrest_.overlap;
    pairs_.forEachOverlap(enter);
}

// One that two others carry, or a plane, is held against rolling by nothing but balance. What
// bounces between two is not loose: drag alone calms it.
void GranularMotion::lookAtHold(std::uint32_t row, double missing)
{
    const double radius = running_.radius[row];
    const double least = kMissingOnCreeping * massOf(radius);
    const int contacts = pairs_.countOn(row, least) + walls_.countOn(row, least);
    const double speed = running_.velocity[row].norm();
    const bool isHeld = contacts >= kContactsThatHold;
    const bool rolls = contacts == 0 || radius * spin_[row].norm() > speed / 2;
    const bool isSlow = speed <= kSpeedOfMoving && missing <= kMissingOnCreeping;
    unrest_.loose += rolls && !isHeld && !isSlow ? 1 : 0;
    isLoose_[row] = rolls && (!isHeld || (didFewMove_ && missing > kMissingOnMoving)) ? 1 : 0;
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
