// SPDX-License-Identifier: MIT
#include "simulation/solver/crowd.hpp"

#include "simulation/solver/tolerances.hpp"

#include <algorithm>
#include <cmath>

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

} // namespace

void Crowd::gather(const Eigen::Vector3d& down)
{
    startGathering(down);
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        if (!pairs_.nearby(row).empty())
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
}

void Crowd::enter(std::uint32_t row)
{
    order_.push_back({-running_.position[row].dot(down_), row, 0});
}

void Crowd::endGathering()
{
    const std::size_t size = order_.size();
    const std::size_t most = size / kFewestInStrip;
    wantedStrips_ = most <= 1 ? 1 : std::min(most, threads_.gather(size >= kWorthWaking));
}

void Crowd::arrange()
{
    std::sort(order_.begin(), order_.end(),
              [](const Height& a, const Height& b)
              { return a.height < b.height || (a.height == b.height && a.row < b.row); });
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
        first += pairs_.nearby(rows_[slot]).size();
    }
    firstNear_[size] = first;
    nearby_.resize(first);
}

// Who is in which strip changes nothing but who waits for whom.
void Crowd::cutIntoStrips()
{
    const std::size_t size = order_.size();
    stripsTouch_ = false;
    if (!isCut())
    {
        strips_.assign(1, {0, static_cast<std::uint32_t>(size)});
        return;
    }
    stripsTouch_ = size > kMostInClusters || !findClusters(size / wantedStrips_);
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
    std::sort(sample_.begin(), sample_.end());
    borders_.clear();
    for (std::size_t k = 1; k < count; ++k)
    {
        borders_.push_back(sample_[k * samples / count]);
    }
    for (std::size_t rank = 0; rank < size; ++rank)
    {
        const auto border = std::upper_bound(borders_.begin(), borders_.end(), at(rank));
        order_[rank].strip = static_cast<std::uint32_t>(border - borders_.begin());
    }
}

// The cluster with the most pairs first, each to the strip that has the least to do.
void Crowd::dealClusters()
{
    load_.assign(order_.size(), 0);
    clusters_.clear();
    for (std::uint32_t rank = 0; rank < order_.size(); ++rank)
    {
        if (lead_[rank] == rank)
        {
            clusters_.push_back(rank);
        }
        load_[lead_[rank]] +=
            1 + static_cast<std::uint32_t>(pairs_.nearby(order_[rank].row).size());
    }
    std::sort(clusters_.begin(), clusters_.end(),
              [this](std::uint32_t a, std::uint32_t b)
              { return load_[a] > load_[b] || (load_[a] == load_[b] && a < b); });
    next_.assign(strips_.size(), 0);
    for (const std::uint32_t lead : clusters_)
    {
        const auto least = std::min_element(next_.begin(), next_.end());
        *least += load_[lead];
        order_[lead].strip = static_cast<std::uint32_t>(least - next_.begin());
    }
    for (std::uint32_t rank = 0; rank < order_.size(); ++rank)
    {
        order_[rank].strip = order_[lead_[rank]].strip;
    }
}

// All members of a cluster get the same lead. Returns false if one has more than `largest`.
bool Crowd::findClusters(std::size_t largest)
{
    const auto size = static_cast<std::uint32_t>(order_.size());
    std::vector<std::uint32_t>& rankOf = slot_;
    rankOf.assign(running_.size(), kNone);
    lead_.resize(size);
    inCluster_.assign(size, 1);
    for (std::uint32_t rank = 0; rank < size; ++rank)
    {
        rankOf[order_[rank].row] = rank;
        lead_[rank] = rank;
    }
    for (std::uint32_t rank = 0; rank < size; ++rank)
    {
        for (const std::uint32_t row : pairs_.nearby(order_[rank].row))
        {
            if (rankOf[row] >= rank)
            {
                continue; // each pair once; or no member
            }
            const std::uint32_t a = leadOf(rank);
            const std::uint32_t b = leadOf(rankOf[row]);
            if (a != b)
            {
                lead_[std::max(a, b)] = std::min(a, b);
                inCluster_[std::min(a, b)] += inCluster_[std::max(a, b)];
                if (inCluster_[std::min(a, b)] > largest)
                {
                    return false;
                }
            }
        }
    }
    for (std::uint32_t rank = 0; rank < size; ++rank)
    {
        lead_[rank] = lead_[lead_[rank]]; // of those below, all know the lowest already
    }
    return true;
}

// On the way others learn of a lower one.
std::uint32_t Crowd::leadOf(std::uint32_t rank)
{
    while (lead_[rank] != rank)
    {
        rank = lead_[rank] = lead_[lead_[rank]];
    }
    return rank;
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
