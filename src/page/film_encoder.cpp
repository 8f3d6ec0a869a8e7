// SPDX-License-Identifier: MIT
#include "page/film_encoder.hpp"

#include "run_file/frame_codec.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace frostfill
{
namespace
{

/// Steps of the grid in the smallest radius, at least: an error of a thousandth of it is a pixel
/// where a sphere is two thousand pixels wide.
constexpr double kStepsPerRadius = 500;

/// Beyond it nothing is drawn anyway, and sums of some places fit into 32 bits. [step]
constexpr double kFurthest = 1 << 27;

/// A sphere that is not seen: it waits for its fall to begin, or is nowhere.
constexpr std::uint8_t kHidden = 3;
constexpr auto kRunning = static_cast<std::uint8_t>(SphereState::running);

} // namespace

FilmEncoder::FilmEncoder(double smallestRadius, double fastest,
                         const std::vector<ColumnValues>& columns)
    : step_(gridOf(smallestRadius, kStepsPerRadius)), fastest_(fastest), columnEncoder_(columns)
{
}

FilmEncoder::Known FilmEncoder::knownOf(const Snapshot& state, const Eigen::Vector3d& centre,
                                        double radius, std::size_t id) const
{
    Known known;
    known.radius = std::llround(std::min(radius / radiusStep(), kFurthest));
    known.group = state.groups[id];
    known.state = static_cast<std::uint8_t>(state.states[id]);
    if (!centre.allFinite() || state.waits(id))
    {
        known.state = kHidden;
    }
    for (int axis = 0; axis < 3 && centre.allFinite(); ++axis)
    {
        const double place = (centre[axis] - state.origin[axis]) / step_;
        known.place[static_cast<std::size_t>(axis)] =
            static_cast<std::int32_t>(std::lround(std::clamp(place, -kFurthest, kFurthest)));
    }
    if (known.state == kRunning && id < state.speeds.size() && fastest_ > 0)
    {
        const double share = static_cast<double>(state.speeds[id]) / fastest_;
        known.speed = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
    }
    return known;
}

void FilmEncoder::addFacts(const Snapshot& state)
{
    times_.raw(state.time);
    for (const std::size_t count :
         {state.running, state.frozen, state.discarded, state.discardedPolygons})
    {
        counts_.count(count);
    }
    for (int i = 0; i < 12; ++i)
    {
        const double number = i < 9 ? state.pose.rotation(i / 3, i % 3) : state.pose.offset[i - 9];
        poses_.raw(number);
    }
}

void FilmEncoder::add(const Snapshot& state, const std::vector<Eigen::Vector3d>& centres,
                      const std::vector<double>& radii)
{
    addFacts(state);
    std::vector<Known> now;
    now.reserve(state.states.size());
    std::vector<std::uint32_t> renewed;
    std::vector<bool> isRenewed(state.states.size());
    std::vector<std::uint32_t> changed;
    for (std::uint32_t id = 0; id < state.states.size(); ++id)
    {
        now.push_back(knownOf(state, centres[id], radii[id], id));
        if (id >= known_.size() || known_[id].radius != now[id].radius ||
            known_[id].group != now[id].group ||
            (known_[id].state != kRunning && now[id].state != kRunning &&
             known_[id].place != now[id].place))
        {
            renewed.push_back(id);
            isRenewed[id] = true;
        }
        else if (known_[id].state != now[id].state)
        {
            changed.push_back(id);
        }
    }
    changes_.count(1);
    changes_.count(now.size());
    changes_.ids(renewed);
    addRenewed(renewed, now);
    changes_.ids(changed);
    for (const std::uint32_t id : changed)
    {
        states_.count(now[id].state);
    }
    addMotion(isRenewed, now);
    addPolygons(state.polygons);
    std::vector<std::uint32_t> all(now.size());
    std::iota(all.begin(), all.end(), 0U);
    columnEncoder_.encode(state, all, columns_);
    known_ = std::move(now);
}

void FilmEncoder::addRenewed(const std::vector<std::uint32_t>& ids, const std::vector<Known>& now)
{
    // Neighbours in number are neighbours in space.
    for (const std::uint32_t id : ids)
    {
        groups_.difference(std::int64_t{now[id].group} - renewed_.group);
        radii_.difference(now[id].radius - renewed_.radius);
        states_.count(now[id].state);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            places_[axis].difference(std::int64_t{now[id].place[axis]} - renewed_.place[axis]);
        }
        renewed_ = now[id];
    }
}

void FilmEncoder::addMotion(const std::vector<bool>& renewed, std::vector<Known>& now)
{
    for (std::size_t id = 0; id < now.size(); ++id)
    {
        const bool runs = now[id].state == kRunning;
        if (!renewed[id] && (runs || known_[id].state == kRunning))
        {
            // It is expected to go on as before.
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                const std::int32_t gone = now[id].place[axis] - known_[id].place[axis];
                places_[axis].difference(std::int64_t{gone} - known_[id].gone[axis]);
                now[id].gone[axis] = runs ? gone : 0;
            }
        }
        if (runs)
        {
            const int before = renewed[id] ? 0 : known_[id].speed;
            speeds_.difference(now[id].speed - before);
        }
    }
}

void FilmEncoder::addPolygons(const std::vector<PolygonState>& polygons)
{
    polygons_.resize(polygons.size(), PolygonState::active);
    std::vector<std::uint32_t> changed;
    for (std::uint32_t id = 0; id < polygons.size(); ++id)
    {
        if (polygons[id] != polygons_[id])
        {
            changed.push_back(id);
        }
    }
    changes_.ids(changed);
    polygons_ = polygons;
}

void FilmEncoder::repeat(const Snapshot& state)
{
    addFacts(state);
    changes_.count(0);
}

std::size_t FilmEncoder::bytes() const
{
    std::size_t sum = 0;
    for (const ByteWriter* out :
         {&times_, &counts_, &poses_, &changes_, &groups_, &radii_, &states_, &places_[0],
          &places_[1], &places_[2], &speeds_, &columns_})
    {
        sum += out->bytes().size();
    }
    return sum;
}

Sections FilmEncoder::take()
{
    Sections sections;
    const auto add = [&](const char* name, ByteWriter& out)
    { sections.emplace_back(name, std::move(out.bytes())); };
    add("times", times_);
    add("counts", counts_);
    add("poses", poses_);
    add("changes", changes_);
    add("groups", groups_);
    add("radii", radii_);
    add("states", states_);
    add("x", places_[0]);
    add("y", places_[1]);
    add("z", places_[2]);
    add("speeds", speeds_);
    add("columns", columns_);
    return sections;
}

} // namespace frostfill
