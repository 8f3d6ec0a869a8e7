// SPDX-License-Identifier: MIT
#include "simulation/freezing/runners.hpp"

#include "simulation/contact/depenetration.hpp"

#include <utility>

namespace frostfill
{

void Runners::add(std::uint32_t id, const Eigen::Vector3d& place, double radius)
{
    if (count_ == runners_.size())
    {
        runners_.emplace_back();
    }
    runners_[count_++].restart(id, place, radius);
}

void Runners::put(std::uint32_t index, const Eigen::Vector3d& place)
{
    runners_[index].position = place;
    runners_[index].around.invalidate(); // what comes to rest is told where it is now
    runners_[index].stale = true;
    grid_.move(index, place);
}

void Runners::restart(std::uint32_t index, const Eigen::Vector3d& place)
{
    Runner& runner = runners_[index];
    runner.restart(runner.id, place, runner.radius);
    grid_.move(index, place);
}

bool Runners::isClear(const Eigen::Vector3d& place, double radius) const
{
    bool clear = true;
    grid_.forEachNear(place, radius + 1 + kClearance,
                      [&](std::uint32_t, const Eigen::Vector3d& p, double radiusThere)
                      {
                          const double contact = radiusThere + radius + kClearance;
                          clear = clear && (p - place).squaredNorm() >= contact * contact;
                      });
    return clear;
}

void Runners::tell(const Eigen::Vector3d& place, double radius)
{
    // A neighbourhood was made within the skin of where its runner is now.
    grid_.forEachNear(place, 1 + radius + 2 * NeighbourList::kSkin,
                      [&](std::uint32_t k, const Eigen::Vector3d&, double)
                      {
                          if (runners_[k].around.add(place, radius))
                          {
                              runners_[k].stale = true;
                              runners_[k].age = 0; // what carries it has only now come to rest
                          }
                      });
}

void Runners::forgetNeighbours()
{
    for (Runner& runner : all())
    {
        runner.around.invalidate();
        runner.yields = true;
    }
}

void Runners::renumber(std::uint32_t from, std::uint32_t to)
{
    for (Runner& runner : all())
    {
        if (runner.id == from)
        {
            runner.id = to;
        }
    }
}

void Runners::startFreezing()
{
    asleep_.assign(count_, false);
    rebuildGrid();
}

// Their memory is kept for spheres to come.
void Runners::removeAsleep()
{
    for (std::size_t k = count_; k-- > 0;)
    {
        if (asleep_[k])
        {
            --count_;
            if (k != count_)
            {
                std::swap(runners_[k], runners_[count_]);
            }
        }
    }
}

} // namespace frostfill
