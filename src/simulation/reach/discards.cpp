// SPDX-License-Identifier: MIT
#include "simulation/reach/discards.hpp"

#include "base/timers.hpp"
#include "mesh/interior/near_surface.hpp"
#include "simulation/world/tolerances.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace frostfill
{
namespace
{

const Eigen::Vector3d kUnknown = Eigen::Vector3d::Constant(std::nan(""));

// Small spheres of a size curve pass between large ones and get everywhere.
bool isExact(const World& world)
{
    return world.scene.discard.rule == DiscardRule::exact &&
           (!world.radii.curve() || world.radii.smallest() > kPassesBetween);
}

/// Whether what is at rest runs again before the end.
bool wakesEverything(const Scene& scene)
{
    return scene.move.any() || scene.rest.mode == Rest::joint ||
           scene.motion.mode == Motion::granular;
}

/// Calls body(first, end) for rows from `first` on, some at a time: of those that are looked at for
/// the first time most go, and those that stay take little memory.
template <class Body>
void forEachRowPart(std::uint32_t first, std::uint32_t end, Body&& body)
{
    constexpr std::uint32_t kTogether = 1U << 14;
    for (; first < end; first += std::min(kTogether, end - first))
    {
        body(first, first + std::min(kTogether, end - first));
    }
}

} // namespace

Discards::Discards(World& world)
    : world_(world), threads_(world.scene.threads),
      search_(world.spheres.resting(), world.triangles, world.radii.smallest()),
      isOff_(!isExact(world)),
      step_(static_cast<std::uint32_t>(std::max<std::size_t>(1, expectedCount(world) / kMarks)))
{
    for (std::uint32_t k = 0; !isOff_ && k < world.polygons.size(); ++k)
    {
        polygons_.push_back({k, true, kUnknown});
    }
}

// Larger cubes would give another answer.
void Discards::use(OpenCubes&& open)
{
    if (!isOff_ && mark_ == 0 && open.cubes.frame().cell <= kReachVoxel * open.probe)
    {
        open_ = std::move(open);
    }
}

void Discards::update()
{
    const std::uint32_t mark = newestMark();
    if (isOff_ || mark <= mark_)
    {
        return;
    }
    const StageTimer timer(world_.counts.times, Stage::discarding);
    if (!findOpenCubes())
    {
        return;
    }
    const SphereGrid& resting = world_.spheres.resting();
    const std::uint32_t before = std::exchange(mark_, mark);
    forEachRowPart(before, mark,
                   [&](std::uint32_t first, std::uint32_t end)
                   {
                       forEachBySlab(
                           resting, end - first, threads_,
                           [&](std::uint32_t k) { return first + k; },
                           [&](std::uint32_t k) { close(resting[first + k]); });
                   });
    discardSpheres(0);
    forEachRowPart(before, mark,
                   [&](std::uint32_t first, std::uint32_t end)
                   {
                       const std::size_t known = spheres_.size();
                       for (std::uint32_t row = first; row < end; ++row)
                       {
                           spheres_.push_back({row, true, kUnknown});
                       }
                       discardSpheres(known);
                   });
    discardPolygons();
}

void Discards::discardSpheres(std::size_t first)
{
    const SphereGrid& resting = world_.spheres.resting();
    const std::span<Kept> some = std::span(spheres_).subspan(first);
    forEachBySlab(
        resting, some.size(), threads_, [&](std::uint32_t k) { return some[k].index; },
        [&](std::uint32_t k)
        {
            Kept& kept = some[k];
            kept.stays = isOpen(kept.witness) || canBeTouched(resting[kept.index], kept.witness);
        });
    const auto goes = [&](const Kept& kept)
    {
        if (!kept.stays)
        {
            world_.spheres.discard(resting.id(kept.index));
        }
        return !kept.stays;
    };
    spheres_.erase(
        std::remove_if(spheres_.begin() + static_cast<std::ptrdiff_t>(first), spheres_.end(), goes),
        spheres_.end());
}

void Discards::discardPolygons()
{
    before_ = kUnknown;
    std::erase_if(polygons_,
                  [&](Kept& kept)
                  {
                      const bool goes = !canBeTouched(kept.index, kept.witness);
                      if (goes)
                      {
                          world_.discardPolygon(kept.index);
                      }
                      return goes;
                  });
}

// Rows at rest are in the order in which the spheres came to rest.
std::uint32_t Discards::newestMark() const
{
    const auto resting = static_cast<std::uint32_t>(world_.spheres.resting().size());
    if (world_.clock.finished)
    {
        return resting;
    }
    const std::uint32_t before = resting - std::min(resting, 1U);
    return wakesEverything(world_.scene) ? 0 : before - before % step_;
}

bool Discards::findOpenCubes()
{
    if (!open_)
    {
        open_ = openCubesOf(world_.surface, world_.inside, world_.radii.smallest(), kMostMapBytes,
                            threads_);
        isOff_ = !open_;
    }
    return open_.has_value();
}

// Closes the cubes that the ball of a sphere at rest excludes as a whole.
void Discards::close(const Ball& ball)
{
    const Cubes& cubes = open_->cubes;
    findRowOfBall(cubes.frame(), ball.position(), open_->exclusion(ball.radius + open_->probe),
                  kInsideBall,
                  [&](int y, int z, CellRun run)
                  {
                      cubes.takeOut(open_->inside, y, z, run);
                      return false;
                  });
}

// Walls stay, and cubes only close. What was found once therefore holds until spheres at rest
// exclude it: a search at each mark took twenty times as long.
bool Discards::isOpen(const Eigen::Vector3d& witness) const
{
    return !std::isnan(witness.x()) && has(open_->inside, open_->cubes.at(witness)) &&
           search_.isStillClear(witness, open_->cubes.frame().cell, mark_);
}

bool Discards::canBeTouched(const Ball& ball, Eigen::Vector3d& witness)
{
    const double reach = ball.radius + world_.radii.largest() + kDiscardGap;
    const double ofPart = reach + ClearSearch::reachOfPart(open_->cubes.frame().cell);
    const Eigen::Vector3d centre = ball.position();
    const GridFrame& frame = open_->cubes.frame();
    if (!open_->cubes.any(open_->inside, frame.coordinates(centre.array() - reach),
                          frame.coordinates(centre.array() + reach)))
    {
        return false;
    }
    const auto isNear = [&](const Eigen::Vector3d& part)
    {
        witness = part; // the last one that is asked for is the one that is found
        return (part - centre).squaredNorm() <= ofPart * ofPart;
    };
    return findRowOfBall(frame, centre, reach, kMeetsBall,
                         [&](int y, int z, CellRun run)
                         {
                             return findPlace(
                                 y, z, run, [](int) { return true; }, isNear);
                         });
}

bool Discards::canBeTouched(std::uint32_t polygon, Eigen::Vector3d& witness)
{
    const Cubes& cubes = open_->cubes;
    const double reach = world_.radii.largest() + kDiscardGap;
    const std::array<std::uint32_t, 1> alone = {polygon};
    const TriangleGroup group = groupOf(world_.surface, alone);
    const NearGroup near(world_.surface, group,
                         reach + ClearSearch::reachOfPart(cubes.frame().cell));
    const auto isNear = [&](const Eigen::Vector3d& part)
    {
        witness = part;
        return near.isNear(polygon, part);
    };
    // Polygons follow each other in a mesh as they lie beside each other in the object.
    if (!std::isnan(before_.x()) && near.isNear(polygon, before_))
    {
        witness = before_;
        return true;
    }
    // Most that can be touched can be where a sphere touches their middle from inside.
    const TriangleBound& bound = world_.surface.bound(polygon);
    const GridPlace beside = cubes.frame().coordinates(
        bound.centre + (world_.radii.smallest() + kDiscardGap) * bound.normal);
    bool found = isOpen(witness) || findPlace(
                                        beside[1], beside[2], {beside[0], beside[0]},
                                        [](int) { return true; }, isNear);
    const double far = reach + kHalfDiagonal * cubes.frame().cell;
    if (!found && cubes.any(open_->inside, cubes.frame().coordinates(group.box.min().array() - far),
                            cubes.frame().coordinates(group.box.max().array() + far)))
    {
        forEachRunNear(cubes.frame(), world_.surface, group, far,
                       [&](int y, int z, CellRun run, auto&& isCubeNear)
                       { found = found || findPlace(y, z, run, isCubeNear, isNear); });
    }
    before_ = found ? witness : before_;
    return found;
}

// Whether one of the cubes of a row that are near may hold a place in a part that is near. Cubes
// that hold none at all are closed.
template <class IsCubeNear, class IsNear>
bool Discards::findPlace(int y, int z, CellRun run, IsCubeNear&& isCubeNear, IsNear&& isNear)
{
    const Cubes& cubes = open_->cubes;
    bool found = false;
    forEachWordOf(run,
                  [&](int x, std::uint64_t bits)
                  {
                      std::uint64_t& open = open_->inside[cubes.word(x, y, z)];
                      for (bits &= open; bits != 0 && !found; bits &= bits - 1)
                      {
                          const int cube = 64 * x + std::countr_zero(bits);
                          if (!isCubeNear(cube))
                          {
                              continue;
                          }
                          const auto place = search_.find(cubes.middle({cube, y, z}),
                                                          cubes.frame().cell, mark_, isNear);
                          found = place == ClearSearch::Place::wanted;
                          open &= place == ClearSearch::Place::none ? ~(bits & -bits) : open;
                      }
                  });
    return found;
}

} // namespace frostfill
