// SPDX-License-Identifier: MIT
#include "simulation/solver/crowd.hpp"

#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <compare>

namespace frostfill
{
namespace
{

/// The axis along which strips follow one another: of x and z the one that leads less along the
/// pull.
int axisOfStrips(const Eigen::Vector3d& down)
{
    return std::abs(down.x()) <= std::abs(down.z()) ? 0 : 2;
}

/// An order of all numbers: what is not finite is found at the end of the step, not in a sort.
bool isBelow(double a, double b)
{
    return std::weak_order(a, b) < 0;
}

} // namespace

void Crowd::gather(const Eigen::Vector3d& down)
{
    startGathering(down);
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        if (pairs_.isPaired(row))
        {
            enter(row);
        }
    }
    endGathering();
}

void Crowd::gather(std::span<const std::uint32_t> rows, const Eigen::Vector3d& down)
{
    startGathering(down);
    for (const std::uint32_t row : rows)
    {
        enter(row);
    }
    endGathering();
}

void Crowd::startGathering(const Eigen::Vector3d& down)
{
    down_ = down;
    order_.clear();
    members_.clear();
}

void Crowd::enter(std::uint32_t row)
{
    order_.push_back({-running_.position[row].dot(down_), row, 0});
    members_.push_back(row);
}

void Crowd::endGathering()
{
    const std::size_t size = order_.size();
    const std::size_t most = size / kFewestInStrip;
    wantedStrips_ = most <= 1 ? 1 : std::min(most, threads_.gather(size >= kWorthWaking));
}

void Crowd::arrange()
{
    order();
    if (isCut())
    {
        cluster();
    }
    cut();
}

void Crowd::cluster()
{
    const std::size_t size = members_.size();
    stripsTouch_ = size > kMostInClusters || !findClusters(size / wantedStrips_);
}

void Crowd::order()
{
    std::sort(order_.begin(), order_.end(),
              [](const Height& a, const Height& b) {
                  return isBelow(a.height, b.height) ||
                         (!isBelow(b.height, a.height) && a.row < b.row);
              });
}

void Crowd::cut()
{
    cutIntoStrips();
    giveSlots();
}

void Crowd::giveSlots()
{
    const std::size_t size = order_.size();
    balls_.resize(size);
    rows_.resize(size);
    ranks_.resize(size);
    firstNear_.resize(size + 1);
    nearCount_.resize(size);
    isShared_.resize(size);
    slot_.assign(running_.size(), kNone);
    next_.clear();
    for (const Strip& strip : strips_)
    {
        next_.push_back(strip.begin);
    }
    for (std::uint32_t rank = 0; rank < size; ++rank)
    {
        const std::uint32_t row = order_[rank].row;
        const std::uint32_t slot = next_[order_[rank].strip]++;
        rows_[slot] = row;
        ranks_[slot] = rank;
        slot_[row] = slot;
    }
    std::size_t first = 0;
    for (std::uint32_t slot = 0; slot < size; ++slot)
    {
        firstNear_[slot] = first;
        first += pairs_.nearbyCount(rows_[slot]);
    }
    firstNear_[size] = first;
    nearby_.resize(first);
}

// Who is in which strip changes nothing but who waits for whom.
void Crowd::cutIntoStrips()
{
    if (!isCut())
    {
        stripsTouch_ = false;
        strips_.assign(1, {0, static_cast<std::uint32_t>(order_.size())});
        return;
    }
    strips_.assign(wantedStrips_, {0, 0});
    stripsTouch_ ? cutByPlace() : dealClusters();
    for (const Height& one : order_)
    {
        ++strips_[one.strip].end;
    }
    std::uint32_t begin = 0;
    for (Strip& strip : strips_)
    {
        strip.begin = begin;
        strip.end = begin += strip.end;
    }
}

// Where strips end, some of the members tell.
void Crowd::cutByPlace()
{
    const int axis = axisOfStrips(down_);
    const auto at = [&](std::size_t rank) { return running_.position[order_[rank].row][axis]; };
    const std::size_t size = order_.size();
    const std::size_t count = strips_.size();
    const std::size_t samples = std::min(size, kSamplesOfStrip * count);
    sample_.resize(samples);
    for (std::size_t k = 0; k < samples; ++k)
    {
        sample_[k] = at(k * size / samples);
    }
    std::sort(sample_.begin(), sample_.end(), isBelow);
    borders_.clear();
    for (std::size_t k = 1; k < count; ++k)
    {
        borders_.push_back(sample_[k * samples / count]);
    }
    for (std::size_t rank = 0; rank < size; ++rank)
    {
        const auto border = std::upper_bound(borders_.begin(), borders_.end(), at(rank), isBelow);
        order_[rank].strip = static_cast<std::uint32_t>(border - borders_.begin());
    }
}

// The cluster with the most pairs first, each to the strip that has the least to do.
void Crowd::dealClusters()
{
    clusters_.clear();
    for (const std::uint32_t row : members_)
    {
        if (lead_[row] == row)
        {
            clusters_.push_back(row);
            load_[row] = 0;
        }
    }
    for (const std::uint32_t row : members_)
    {
        load_[lead_[row]] += 1 + pairs_.nearbyCount(row);
    }
    std::sort(clusters_.begin(), clusters_.end(),
              [this](std::uint32_t a, std::uint32_t b)
              { return load_[a] > load_[b] || (load_[a] == load_[b] && a < b); });
    next_.assign(strips_.size(), 0);
    for (const std::uint32_t lead : clusters_)
    {
        const auto least = std::min_element(next_.begin(), next_.end());
        *least += load_[lead];
        load_[lead] = static_cast<std::uint32_t>(least - next_.begin());
    }
    for (Height& one : order_)
    {
        one.strip = load_[lead_[one.row]];
    }
}

// All members of a cluster get the same lead. Returns false if one has more than `largest`.
bool Crowd::findClusters(std::size_t largest)
{
    lead_.assign(running_.size(), kNone);
    inCluster_.assign(running_.size(), 1);
    load_.resize(running_.size());
    for (const std::uint32_t row : members_)
    {
        lead_[row] = row;
    }
    for (const std::uint32_t row : members_)
    {
        for (const std::uint32_t other : pairs_.nearby(row))
        {
            if (other < row && lead_[other] != kNone)
            {
                join(row, other);
            }
        }
        if (inCluster_[leadOf(row)] > largest)
        {
            return false;
        }
    }
    for (const std::uint32_t row : members_)
    {
        lead_[row] = leadOf(row);
    }
    return true;
}

void Crowd::join(std::uint32_t a, std::uint32_t b)
{
    a = leadOf(a);
    b = leadOf(b);
    if (a != b)
    {
        lead_[std::max(a, b)] = std::min(a, b);
        inCluster_[std::min(a, b)] += inCluster_[std::max(a, b)];
    }
}

// On the way others learn of an earlier one.
std::uint32_t Crowd::leadOf(std::uint32_t row)
{
    while (lead_[row] != row)
    {
        row = lead_[row] = lead_[lead_[row]];
    }
    return row;
}

void Crowd::enlist(std::size_t k)
{
    const Strip& strip = strips_[k];
    for (std::uint32_t slot = strip.begin; slot < strip.end; ++slot)
    {
        balls_[slot].radius = running_.radius[rows_[slot]];
        follow(slot);
        Near* next = nearby_.data() + firstNear_[slot];
        bool shared = false;
        for (const std::uint32_t row : pairs_.nearby(rows_[slot]))
        {
            const std::uint32_t other = slot_[row];
            if (other == kNone)
            {
                continue;
            }
            const bool foreign = other < strip.begin || other >= strip.end;
            shared = shared || foreign;
            *next++ = {other & kLargestSlot, ranks_[other] < ranks_[slot], foreign};
        }
        nearCount_[slot] = static_cast<std::uint32_t>(next - (nearby_.data() + firstNear_[slot]));
        isShared_[slot] = shared ? 1 : 0;
    }
}

} // namespace frostfill
