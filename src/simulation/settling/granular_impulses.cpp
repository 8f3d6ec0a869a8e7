// SPDX-License-Identifier: MIT
#include "simulation/settling/granular_motion.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

void GranularMotion::advanceByImpulses(double time, const Course& course, bool givesWay)
{
    takeSprings(false);
    const double step = didFewMove_ ? kStepOfFew : kStepOfImpulses;
    const std::size_t steps = divide(time, step * std::sqrt(world_.radii.smallest()));
    active_.assign(running_.size(), 1);
    wake();
    for (std::size_t k = 0; k < steps && !world_.stop.isAsked(); ++k)
    {
        stepByImpulses(course, givesWay ? kStiffnessOfImpulses * softest_ : 0);
    }
    look(!givesWay);
}

void GranularMotion::stepByImpulses(const Course& course, double stiffness)
{
    if (!isListed_)
    {
        list();
    }
    plan();
    threads_.forEach(
        rows_.size(),
        [&](std::size_t k)
        {
            const std::uint32_t row = rows_[k];
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
        sweeps_.plan(active_, 2 * *std::max_element(reaches.begin(), reaches.end()));
        isPlanned_ = true;
    }
}

} // namespace frostfill
