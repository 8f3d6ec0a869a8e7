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
    if (!isOff_)
    {
        polygons_.reserve(world.polygons.size());
        for (const std::uint32_t polygon : world.surface.tree().order())
        {
            polygons_.push_back({polygon, true, kUnknown});
        }
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
    const Cubes& cubes = open_->cubes;
    const auto find = [&](const GridPlace& cube, auto&& isNear)
    { return search_.find(cubes.middle(cube), cubes.frame().cell, mark_, isNear); };
    forEachBySlab(
        resting, some.size(), threads_, [&](std::uint32_t k) { return some[k].index; },
        [&](std::uint32_t k)
        {
            Kept& kept = some[k];
            kept.stays =
                isOpen(kept.witness) || canBeTouched(resting[kept.index], kept.witness, find);
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

// Polygons side by side are looked at together first: those of a fine mesh mostly go together.
void Discards::discardPolygons()
{
    constexpr std::size_t kTogether = 16;
    before_ = kUnknown;
    known_.assign(kKnownSide * kKnownSide * kKnownSide, {{-1, -1, -1}, 0});
    for (std::size_t first = 0; first < polygons_.size(); first += kTogether)
    {
        const std::span<Kept> some =
            std::span(polygons_).subspan(first, std::min(kTogether, polygons_.size() - first));
        Eigen::AlignedBox3d box;
        for (const Kept& kept : some)
        {
            const auto& [a, b, c] = world_.surface[kept.index].corner;
            box.extend(a).extend(b).extend(c);
        }
        const Eigen::Vector3d middle = box.center();
        const double size = box.diagonal().norm();
        isFine_ = size < open_->cubes.frame().cell;
        Eigen::Vector3d place = kUnknown; // the search leaves one here even if it finds none
        const bool any = size > world_.radii.largest() ||
                         canBeTouched({middle.x(), middle.y(), middle.z(), size / 2}, place,
                                      [&](const GridPlace& cube, auto&& isNear)
                                      { return findAmongKnown(cube, isNear); });
        before_ = any && !std::isnan(place.x()) ? place : before_;
        for (Kept& kept : some)
        {
            kept.stays = any && canBeTouched(kept.index, kept.witness);
            if (!kept.stays)
            {
                world_.discardPolygon(kept.index);
            }
        }
    }
    std::erase_if(polygons_, [](const Kept& kept) { return !kept.stays; });
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

template <class Find>
bool Discards::canBeTouched(const Ball& ball, Eigen::Vector3d& witness, Find&& find)
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
    const auto findNear = [&](const GridPlace& cube) { return find(cube, isNear); };
    return findRowOfBall(frame, centre, reach, kMeetsBall,
                         [&](int y, int z, CellRun run) { return findPlace(y, z, run, findNear); });
}

bool Discards::canBeTouched(std::uint32_t polygon, Eigen::Vector3d& witness)
{
    const GridFrame& frame = open_->cubes.frame();
    const double reach = world_.radii.largest() + kDiscardGap;
    const std::array<std::uint32_t, 1> alone = {polygon};
    const TriangleGroup group = groupOf(world_.surface, alone);
    const NearGroup near(world_.surface, group, reach + ClearSearch::reachOfPart(frame.cell));
    // A place that was found for one polygon is mostly near the next one.
    if (near.isNear(polygon, before_))
    {
        witness = before_;
        return true;
    }
    const auto isNear = [&](const Eigen::Vector3d& part)
    {
        witness = part;
        return near.isNear(polygon, part);
    };
    // Most that can be touched can be where a sphere touches their middle from inside.
    const TriangleBound& bound = world_.surface.bound(polygon);
    const GridPlace beside =
        frame.coordinates(bound.centre + (world_.radii.smallest() + kDiscardGap) * bound.normal);
    bool found = isOpen(witness) ||
                 findPlace(beside[1], beside[2], {beside[0], beside[0]},
                           [&](const GridPlace& cube) { return findAmongKnown(cube, isNear); });
    const auto findNear = [&](int y, int z, CellRun run, auto&& isCubeNear)
    {
        const auto findIfNear = [&](const GridPlace& cube) {
            return isCubeNear(cube[0]) ? findAmongKnown(cube, isNear)
                                       : ClearSearch::Place::elsewhere;
        };
        found = found || findPlace(y, z, run, findIfNear);
    };
    const double far = reach + kHalfDiagonal * frame.cell;
    if (!found && open_->cubes.any(open_->inside, frame.coordinates(group.box.min().array() - far),
                                   frame.coordinates(group.box.max().array() + far)))
    {
        forEachRunNear(frame, world_.surface, group, far, findNear);
    }
    before_ = found ? witness : before_;
    return found;
}

// As ClearSearch::find. Polygons that are smaller than cubes ask for the same ones again and again.
template <class IsWanted>
ClearSearch::Place Discards::findAmongKnown(const GridPlace& cube, IsWanted&& isWanted)
{
    const auto digits = [](int place) { return static_cast<unsigned>(place) % kKnownSide; };
    Known& known =
        known_[(digits(cube[2]) * kKnownSide + digits(cube[1])) * kKnownSide + digits(cube[0])];
    const Eigen::Vector3d middle = open_->cubes.middle(cube);
    const double edge = open_->cubes.frame().cell;
    if (!isFine_)
    {
        return search_.find(middle, edge, mark_, isWanted);
    }
    if (known.cube != cube)
    {
        known = {cube, search_.clearParts(middle, edge, mark_)};
    }
    const CubeParts parts(middle, edge);
    for (std::uint64_t left = known.parts; left != 0; left &= left - 1)
    {
        if (isWanted(parts.middle(static_cast<std::size_t>(std::countr_zero(left)))))
        {
            return ClearSearch::Place::wanted;
        }
    }
    return known.parts == 0 ? ClearSearch::Place::none : ClearSearch::Place::elsewhere;
}

// Whether find(cube) finds a place in one of the open cubes of a row. Cubes that hold none at all
// are closed.
template <class Find>
bool Discards::findPlace(int y, int z, CellRun run, Find&& find)
{
    bool found = false;
    forEachWordOf(run,
                  [&](int x, std::uint64_t bits)
                  {
                      std::uint64_t& open = open_->inside[open_->cubes.word(x, y, z)];
                      for (bits &= open; bits != 0 && !found; bits &= bits - 1)
                      {
                          const auto place = find({64 * x + std::countr_zero(bits), y, z});
                          found = place == ClearSearch::Place::wanted;
                          open &= place == ClearSearch::Place::none ? ~(bits & -bits) : open;
                      }
                  });
    return found;
}

} // namespace frostfill
