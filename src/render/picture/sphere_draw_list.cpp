// SPDX-License-Identifier: MIT
#include "render/picture/sphere_draw_list.hpp"

#include "render/picture/for_all.hpp"

#include <frostfill/columns.hpp>

#include <Eigen/Geometry>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace frostfill
{

namespace
{

constexpr int kKeyBits = 22;

/// The mesh lies within 1 of unit space's origin, so that steps are a millionth of its size.
std::uint32_t sortKey(float distance)
{
    constexpr float kMax = (1 << kKeyBits) - 1;
    return static_cast<std::uint32_t>(std::clamp((distance + 2) * 0.25F * kMax, 0.0F, kMax));
}

constexpr int kPlaceBits = 32;

/// Returns the keys of places, each above its place, in their order; equal keys as they came.
template <typename KeyOf>
std::vector<std::uint64_t> sortedKeys(std::size_t count, KeyOf keyOf)
{
    std::vector<std::uint64_t> keys(count);
    forAll(count, kSpheresPerTask,
           [&](std::size_t i) { keys[i] = std::uint64_t{keyOf(i)} << kPlaceBits | i; });
    tbb::parallel_sort(keys.begin(), keys.end());
    return keys;
}

glm::vec3 centreOf(const SphereInstance& sphere)
{
    return {sphere.x, sphere.y, sphere.z};
}

std::array<const ColumnValues*, 4> turnedIn(const Snapshot& snapshot)
{
    std::array<const ColumnValues*, 4> turned{};
    const std::array names = {"qx", "qy", "qz", "qw"};
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        turned[i] = findValues(snapshot.columns, *findColumn(names[i]));
    }
    const bool all = std::find(turned.begin(), turned.end(), nullptr) == turned.end();
    return all ? turned : std::array<const ColumnValues*, 4>{};
}

} // namespace

Eigen::Vector3d stripeAxis()
{
    return {0.8, 0.36, 0.48};
}

bool SphereDrawList::knowsWhatChanged(const Snapshot& snapshot) const
{
    return snapshot.source != 0 && snapshot.source == source_ &&
           snapshot.changedSince <= revision_ && revision_ <= snapshot.revision &&
           snapshot.centres.size() >= places_.size();
}

std::uint32_t SphereDrawList::stateWord(const Snapshot& snapshot, std::uint32_t id) const
{
    auto word = static_cast<std::uint32_t>(colours_->marked(snapshot.states[id]));
    if (turned_[0] != nullptr)
    {
        const auto part = [&](std::size_t i) { return turned_[i]->at(id); };
        const Eigen::Quaterniond turned(part(3), part(0), part(1), part(2));
        const Eigen::Vector3d axis = turned.normalized() * stripeAxis();
        for (int k = 0; k < 3; ++k)
        {
            const auto byte = static_cast<std::uint8_t>(std::lround(127 * axis[k]));
            word |= std::uint32_t{byte} << (8 * (k + 1));
        }
    }
    return word;
}

SphereInstance SphereDrawList::instance(const Snapshot& snapshot, std::uint32_t id) const
{
    const Eigen::Vector3f centre = snapshot.centres[id] * scale_ + offset_;
    return {centre.x(),
            centre.y(),
            centre.z(),
            snapshot.radii[id] * scale_,
            stateWord(snapshot, id),
            colours_->of(snapshot, id)};
}

void SphereDrawList::lookAt(const Snapshot& snapshot, std::uint32_t id)
{
    const bool runs = snapshot.states[id] == SphereState::running;
    const bool isNew = id >= places_.size();
    if (isNew)
    {
        places_.push_back(kRuns);
    }
    if (!isNew && places_[id] != kRuns)
    {
        SphereInstance& held = resting_[places_[id]];
        const SphereInstance now = instance(snapshot, id);
        if (now == held)
        {
            return;
        }
        const SphereInstance before = std::exchange(held, now);
        // At rest for good, or else the whole order is void.
        const bool moved = before.x != now.x || before.y != now.y || before.z != now.z ||
                           before.radius != now.radius;
        changes_.everything = changes_.everything || runs || moved;
        changes_.recoloured.push_back(places_[id]);
        return;
    }
    if (runs)
    {
        if (isNew)
        {
            runningIds_.push_back(id);
        }
        return;
    }
    places_[id] = static_cast<std::uint32_t>(resting_.size());
    restingIds_.push_back(id);
    resting_.push_back(instance(snapshot, id));
}

void SphereDrawList::startAgain(const Snapshot& snapshot)
{
    places_.clear();
    restingIds_.clear();
    resting_.clear();
    cells_.clear();
    runningIds_.clear();
    changes_ = {};
    places_.reserve(snapshot.centres.size());
    restingIds_.reserve(snapshot.centres.size());
    resting_.reserve(snapshot.centres.size());
    for (std::uint32_t id = 0; id < snapshot.centres.size(); ++id)
    {
        lookAt(snapshot, id);
    }
    changes_.everything = true;
}

const SphereDrawList::Changes& SphereDrawList::update(const Snapshot& snapshot,
                                                      const Framing& framing,
                                                      const SphereColours& colours)
{
    colours.requireIn(snapshot);
    colours_ = &colours;
    turned_ = turnedIn(snapshot);
    const Eigen::Vector3f offset =
        ((snapshot.origin - framing.centre) * framing.scale).cast<float>();
    const auto scale = static_cast<float>(framing.scale);
    const bool sameFrame = offset == offset_ && scale == scale_;
    offset_ = offset;
    scale_ = scale;

    changes_ = {};
    changes_.firstArrival = resting_.size();
    if (!sameFrame || snapshot.centres.size() < places_.size())
    {
        startAgain(snapshot);
    }
    else if (knowsWhatChanged(snapshot))
    {
        const bool isTheSame =
            snapshot.revision == revision_ && snapshot.centres.size() == places_.size();
        for (const std::uint32_t id :
             isTheSame ? std::span<const std::uint32_t>() : std::span(snapshot.changed))
        {
            lookAt(snapshot, id);
        }
    }
    else
    {
        for (std::uint32_t id = 0; id < snapshot.centres.size(); ++id)
        {
            lookAt(snapshot, id);
        }
    }
    if (changes_.everything || places_.size() != snapshot.centres.size())
    {
        startAgain(snapshot);
    }
    source_ = snapshot.source;
    revision_ = snapshot.revision;

    std::erase_if(runningIds_, [&](std::uint32_t id) { return places_[id] != kRuns; });
    running_.clear();
    for (const std::uint32_t id : runningIds_)
    {
        if (!snapshot.waits(id))
        {
            running_.push_back(instance(snapshot, id));
        }
    }
    return changes_;
}

std::vector<std::uint32_t> nearestFirst(std::span<const SphereInstance> spheres,
                                        const Framing& framing)
{
    // The eye is a point, or without perspective a direction.
    const glm::vec3 eye(framing.eye);
    const float eyeDistance = glm::length(eye);
    const auto keyOf = [&](std::size_t i)
    {
        const glm::vec3 centre = centreOf(spheres[i]);
        return sortKey(framing.orthographic ? -glm::dot(centre, eye)
                                            : glm::length(centre - eye) - eyeDistance);
    };
    const std::vector<std::uint64_t> keys = sortedKeys(spheres.size(), keyOf);
    return {keys.begin(), keys.end()}; // without the keys
}

void SphereDrawList::reorder(std::vector<std::uint32_t> order)
{
    // Round by round, in place: there are millions.
    for (std::uint32_t start = 0; start < order.size(); ++start)
    {
        const SphereInstance first = resting_[start];
        const std::uint32_t id = restingIds_[start];
        std::uint32_t to = start;
        for (std::uint32_t from = order[to]; from != start; from = order[to])
        {
            resting_[to] = resting_[from];
            restingIds_[to] = restingIds_[from];
            order[to] = to;
            to = from;
        }
        resting_[to] = first;
        restingIds_[to] = id;
        order[to] = to;
    }
    forAll(restingIds_.size(), kSpheresPerTask,
           [&](std::size_t i) { places_[restingIds_[i]] = static_cast<std::uint32_t>(i); });
}

void SphereDrawList::sortFrontToBack(const Framing& framing)
{
    reorder(nearestFirst(resting_, framing));
}

bool SphereDrawList::orderByCells()
{
    if (!cells_.empty() && 2 * std::size_t{cells_.back().end} > resting_.size())
    {
        return false;
    }
    auto [order, cells] = frostfill::orderByCells(resting_);
    reorder(std::move(order));
    cells_ = std::move(cells);
    return true;
}

namespace
{

/// Of a cell, in the mean. Fewer: more cells to place and order. More: more hidden spheres are
/// looked at.
constexpr double kInCell = 48;
constexpr std::uint32_t kMostInCell = 96;

constexpr int kAxisBits = 10;

/// The bits of a number of ten, two apart.
std::uint32_t spread(std::uint32_t value)
{
    std::uint32_t bits = 0;
    for (int k = 0; k < kAxisBits; ++k)
    {
        bits |= (value >> k & 1U) << (3 * k);
    }
    return bits;
}

struct Box
{
    glm::vec3 low, high;
};

Box boxOfCentres(std::span<const SphereInstance> spheres)
{
    Box box = {centreOf(spheres[0]), centreOf(spheres[0])};
    for (const SphereInstance& sphere : spheres)
    {
        box.low = glm::min(box.low, centreOf(sphere));
        box.high = glm::max(box.high, centreOf(sphere));
    }
    return box;
}

SphereInstance around(std::span<const SphereInstance> spheres)
{
    const auto [low, high] = boxOfCentres(spheres);
    const glm::vec3 middle = 0.5F * (low + high);
    float reach = 0;
    for (const SphereInstance& sphere : spheres)
    {
        reach = std::max(reach, glm::length(centreOf(sphere) - middle) + sphere.radius);
    }
    return {middle.x, middle.y, middle.z, 1.0001F * reach, 0};
}

} // namespace

CellOrder orderByCells(std::span<const SphereInstance> spheres)
{
    CellOrder result;
    if (spheres.empty())
    {
        return result;
    }
    const auto [low, high] = boxOfCentres(spheres);
    const glm::dvec3 size = glm::max(glm::dvec3(high - low), 1e-6);
    const double wanted = static_cast<double>(spheres.size()) / kInCell;
    constexpr float kLast = (1 << kAxisBits) - 1;
    const auto perLength = static_cast<float>(std::cbrt(wanted / (size.x * size.y * size.z)));
    // By the number of their cell along a curve that keeps neighbours together.
    const auto cellOf = [&, low = low](std::size_t i)
    {
        const glm::uvec3 place(glm::clamp(perLength * (centreOf(spheres[i]) - low), 0.0F, kLast));
        return spread(place.x) | spread(place.y) << 1 | spread(place.z) << 2;
    };
    const std::vector<std::uint64_t> keys = sortedKeys(spheres.size(), cellOf);
    const auto count = static_cast<std::uint32_t>(keys.size());
    for (std::uint32_t first = 0; first < count;)
    {
        std::uint32_t end = first + 1;
        while (end < count && end - first < kMostInCell &&
               keys[end] >> kPlaceBits == keys[first] >> kPlaceBits)
        {
            ++end;
        }
        result.cells.push_back({first, end, {}});
        first = end;
    }
    forAll(result.cells.size(), kSpheresPerTask / kMostInCell,
           [&](std::size_t c)
           {
               SphereCell& cell = result.cells[c];
               std::vector<SphereInstance> own;
               for (std::uint32_t i = cell.first; i < cell.end; ++i)
               {
                   own.push_back(spheres[static_cast<std::uint32_t>(keys[i])]);
               }
               cell.around = around(own);
           });
    result.order.assign(keys.begin(), keys.end()); // without the keys
    return result;
}

} // namespace frostfill
