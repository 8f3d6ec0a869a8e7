// SPDX-License-Identifier: MIT
#include "simulation/world/spheres.hpp"

#include "scene/packing_estimate.hpp"
#include "simulation/world/tolerances.hpp"

#include <fmt/format.h>

#include <bit>
#include <numbers>

namespace frostfill
{

int finerLevels(double smallest, double meanCube, const std::function<double(double)>& upTo)
{
    const double density = // of all spheres [1 / r^3]
        kPackingFraction / (4.0 / 3.0 * std::numbers::pi * meanCube);
    int levels = 0;
    for (double largest = 0.5; largest >= smallest; largest /= 2)
    {
        const double cell = 4 * largest; // of the level above
        const double inCell = density * upTo(largest) * cell * cell * cell;
        if (inCell <= kCrowdedCell)
        {
            break;
        }
        ++levels;
    }
    return levels;
}

void Spheres::reserve(std::size_t count)
{
    where_.reserve(count);
    group_.reserve(count);
    resting_.reserve(count);
}

void Spheres::run(std::uint32_t id, const Eigen::Vector3d& place, double radius)
{
    const std::uint32_t row = running_.rows_++;
    for (RowFollower* column : running_.columns_)
    {
        column->fit(running_.rows_);
    }
    running_.id[row] = id;
    running_.radius[row] = radius;
    where_[id] = 2 * row + kRuns;
    running_.restart(row, place);
}

std::uint32_t Spheres::rest(std::uint32_t id, const Eigen::Vector3d& place, double radius)
{
    const std::uint32_t row = resting_.insert(id, place, radius);
    where_[id] = 2 * row;
    changes_.add(id, size());
    return row;
}

std::uint32_t Spheres::appear(std::uint32_t group)
{
    where_.push_back(0);
    group_.push_back(group);
    return static_cast<std::uint32_t>(size() - 1);
}

std::uint32_t Spheres::add(const Eigen::Vector3d& place, double radius, std::uint32_t group)
{
    const std::uint32_t id = appear(group);
    run(id, place, radius);
    return id;
}

std::uint32_t Spheres::addResting(const Eigen::Vector3d& place, double radius, std::uint32_t group)
{
    const std::uint32_t id = appear(group);
    rest(id, place, radius);
    return id;
}

std::uint32_t Spheres::freeze(std::uint32_t id, const Eigen::Vector3d& place)
{
    const std::uint32_t row = where_[id] >> 1;
    running_.id[row] = RunningSpheres::kNoSphere;
    gaps_ = true;
    return rest(id, place, running_.radius[row]);
}

std::uint32_t Spheres::withdraw(std::uint32_t id)
{
    running_.id[row(id)] = RunningSpheres::kNoSphere;
    gaps_ = true;
    const auto last = static_cast<std::uint32_t>(size() - 1);
    if (last != id)
    {
        if (isRunning(last))
        {
            running_.id[row(last)] = id;
        }
        else
        {
            resting_.renumber(row(last), id);
        }
        where_[id] = where_[last];
        changes_.add(id, size());
    }
    where_.pop_back();
    group_.pop_back(); // a group goes with the id, not with the sphere
    return last;
}

void Spheres::closeRanks()
{
    for (std::uint32_t row = gaps_ ? running_.rows_ : 0; row-- > 0;)
    {
        if (!running_.isGone(row))
        {
            continue;
        }
        const std::uint32_t last = --running_.rows_;
        if (row != last)
        {
            for (RowFollower* column : running_.columns_)
            {
                column->swap(row, last);
            }
            where_[running_.id[row]] = 2 * row + kRuns;
        }
    }
    gaps_ = false;
}

void Spheres::wake(std::uint32_t id)
{
    const std::uint32_t gone = row(id);
    const Ball ball = resting_[gone];
    discarded_ -= resting_.isDiscarded(gone) ? 1 : 0;
    resting_.remove(gone);
    if (gone < resting_.size())
    {
        where_[resting_.id(gone)] = 2 * gone;
    }
    run(id, ball.position(), ball.radius);
    changes_.add(id, size());
}

void Spheres::discard(std::uint32_t id)
{
    resting_.discard(row(id));
    ++discarded_;
    changes_.add(id, size());
}

std::string hashState(const Spheres& spheres)
{
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto take = [&hash](std::uint64_t word)
    {
        hash = (hash ^ word) * 0x100000001b3;
        hash ^= hash >> 32; // FNV is meant for bytes; this lets the high bits of a word count too
    };
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        for (const double coordinate : spheres.position(i))
        {
            take(std::bit_cast<std::uint64_t>(coordinate));
        }
        take(spheres.isRunning(i) ? 0 : 1);
    }
    return fmt::format("{:016x}", hash);
}

} // namespace frostfill
