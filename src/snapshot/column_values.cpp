// SPDX-License-Identifier: MIT
#include <frostfill/columns.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace frostfill
{
namespace
{

/// With so many binary digits behind the first, as far as that leaves a number.
float rounded(float value, int digits)
{
    constexpr int kAll = 23;
    if (digits <= 0 || digits >= kAll)
    {
        return value;
    }
    const int lost = kAll - digits;
    const auto bits = std::bit_cast<std::uint32_t>(value) + (1U << (lost - 1));
    const auto result = std::bit_cast<float>(bits >> lost << lost);
    return std::isfinite(result) ? result : value;
}

} // namespace

double ColumnValues::at(std::size_t sphere) const
{
    const std::uint32_t value = sphere < bits.size() ? bits[sphere] : 0;
    return column_->isWhole() ? double(value) : double{std::bit_cast<float>(value)};
}

bool ColumnValues::set(std::size_t sphere, double value)
{
    const auto now =
        column_->isWhole()
            ? static_cast<std::uint32_t>(value)
            : std::bit_cast<std::uint32_t>(rounded(static_cast<float>(value), column_->digits));
    return std::exchange(bits[sphere], now) != now;
}

} // namespace frostfill
