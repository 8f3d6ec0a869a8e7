// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace frostfill
{

/// Values sorted into numbered buckets, in each in the order in which they came.
template <class Value>
class Buckets
{
public:
    Buckets() = default;
    /// Sorts by counting. `forEach(enter)` calls enter(bucket, value) for all values; it is called
    /// twice and does the same each time.
    template <class ForEach>
    Buckets(std::size_t count, ForEach&& forEach) : starts_(count + 1, 0)
    {
        forEach([this](std::size_t bucket, const Value&) { ++starts_[bucket]; });
        std::exclusive_scan(starts_.begin(), starts_.end(), starts_.begin(), std::uint32_t{0});
        values_.resize(starts_.back());
        forEach([this](std::size_t bucket, const Value& value)
                { values_[starts_[bucket]++] = value; });
        // Each start has become an end, where the next bucket starts.
        std::copy_backward(starts_.begin(), starts_.end() - 1, starts_.end());
        starts_.front() = 0;
    }

    /// Of buckets.
    [[nodiscard]] std::size_t size() const { return starts_.size() - 1; }
    [[nodiscard]] std::span<const Value> operator[](std::size_t bucket) const
    {
        return {values_.data() + starts_[bucket], starts_[bucket + 1] - starts_[bucket]};
    }
    [[nodiscard]] std::span<Value> operator[](std::size_t bucket)
    {
        return {values_.data() + starts_[bucket], starts_[bucket + 1] - starts_[bucket]};
    }
    /// [size() + 1] Where the values of each bucket start among all.
    [[nodiscard]] const std::vector<std::uint32_t>& starts() const { return starts_; }
    [[nodiscard]] std::span<const Value> values() const { return values_; }

private:
    std::vector<std::uint32_t> starts_ = {0};
    std::vector<Value> values_;
};

} // namespace frostfill
