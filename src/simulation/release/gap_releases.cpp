// SPDX-License-Identifier: MIT
#include "simulation/release/gap_releases.hpp"

#include "simulation/release/size_draws.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

GapReleases::GapReleases(const World& world, double band, Threads& threads)
    : world_(world), threads_(threads), band_(band)
{
    double below = 0;
    for (const double limit : classLimits(world.radii))
    {
        const double share = world.radii.curve()->cumulative(limit, SizeCurve::kNumber);
        if (share > below)
        {
            classes_.push_back({below, share, limit});
            below = share;
        }
    }
    std::reverse(classes_.begin(), classes_.end());
    for (std::uint32_t id = 0; id < world.spheres.size(); ++id)
    {
        const auto smaller =
            std::find_if(classes_.begin() + 1, classes_.end(),
                         [&](const Class& one) { return one.largest < world.spheres.radius(id); });
        ++(smaller - 1)->placed;
        ++draws_;
    }
    all_ = static_cast<double>(world.targetCount);
    enter(0);
}

// Sites of classes that come later are not kept up to date, but found when their turn comes.
void GapReleases::enter(std::size_t index)
{
    current_ = index;
    drawn_.reset();
    sites_.reset();
    if (index == 1 && all_ == 0)
    {
        const Class& largest = classes_.front();
        all_ = static_cast<double>(largest.placed) / (largest.high - largest.low);
    }
    if (index < classes_.size())
    {
        sites_.emplace(world_, classes_[index].largest, index == 0 ? band_ : -1, threads_);
        sites_->scatter(index > 0);
    }
}

// Until full, the largest are as many as fit; and the smallest, if the curve need not be kept.
bool GapReleases::isComplete() const
{
    const bool isLast = current_ + 1 == classes_.size();
    if (all_ == 0 || (isLast && world_.targetCount == 0 && !world_.scene.spheres.sizes.within))
    {
        return false;
    }
    const Class& one = classes_[current_];
    // Down to its smallest: so that rounding adds up to no more than one sphere.
    std::size_t before = 0;
    for (std::size_t k = 0; k <= current_; ++k)
    {
        before += classes_[k].placed;
    }
    const double wanted = isLast ? all_ : all_ * (1 - one.low);
    return static_cast<double>(before) >= std::round(wanted) ||
           static_cast<double>(one.placed) >= std::ceil(all_ * (one.high - one.low));
}

std::optional<PlacedSphere> GapReleases::next(const ReleaseQuery& query)
{
    while (current_ < classes_.size())
    {
        if (isComplete())
        {
            enter(current_ + 1);
            continue;
        }
        if (!drawn_)
        {
            drawn_ = radiusOfDraw(++draws_);
        }
        const double radius = *drawn_;
        if (const auto place = sites_->find(radius, query))
        {
            ++classes_[current_].placed;
            drawn_.reset();
            return PlacedSphere{*place, radius};
        }
        if (query.isStopped() || sites_->any())
        {
            return std::nullopt; // it has not looked everywhere, or others run through a place
        }
        enter(current_ + 1);
    }
    return std::nullopt;
}

std::optional<Eigen::Vector3d> GapReleases::place(double radius, const ReleaseQuery& query)
{
    return ReleaseSites(world_, radius, -1, threads_).find(radius, query);
}

void GapReleases::close(const Eigen::Vector3d& centre, double radius)
{
    if (sites_)
    {
        sites_->close(centre, radius);
    }
}

double GapReleases::radiusOfDraw(std::uint64_t number) const
{
    const Class& one = classes_[current_];
    const double share = evenRandom(world_.scene.seed, number);
    return world_.radii.curve()->quantile(one.low + share * (one.high - one.low));
}

} // namespace frostfill
