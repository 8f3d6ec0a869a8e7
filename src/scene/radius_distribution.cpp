// SPDX-License-Identifier: MIT
#include "scene/radius_distribution.hpp"

#include "base/read_number.hpp"
#include "scene/read_sizes.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace frostfill
{
namespace
{

std::string_view withoutSpaces(std::string_view text)
{
    constexpr const char* kSpaces = " \t\r";
    const std::size_t first = text.find_first_not_of(kSpaces);
    if (first == std::string_view::npos)
    {
        return {};
    }
    return text.substr(first, text.find_last_not_of(kSpaces) + 1 - first);
}

std::vector<double> readFile(const std::string& file)
{
    std::ifstream in(file);
    if (!std::filesystem::is_regular_file(file) || !in)
    {
        throw Error(
            ErrorCode::inputMissing,
            fmt::format("cannot read the radii {}: the file does not exist or is not readable",
                        file));
    }
    std::vector<double> radii;
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number)
    {
        const std::string_view text =
            withoutSpaces(std::string_view(line).substr(0, line.find('#')));
        if (text.empty())
        {
            continue;
        }
        const auto radius = readNumber<double>(text);
        if (!radius || !std::isfinite(*radius) || *radius <= 0)
        {
            throw Error(ErrorCode::badData,
                        fmt::format("{}, line {}: '{}' must be a radius, a number above 0", file,
                                    number, text));
        }
        radii.push_back(*radius);
    }
    if (radii.empty())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{} has no radii; write one on each line", file));
    }
    return radii;
}

} // namespace

RadiusDistribution::RadiusDistribution(const Radii& radii)
    : smallest_(radii.smallest), largest_(radii.largest)
{
    if (!radii.file.empty())
    {
        values_ = readFile(radii.file);
        std::sort(values_.begin(), values_.end());
        smallest_ = values_.front();
        largest_ = values_.back();
    }
    if (equal())
    {
        values_.clear();
    }
}

RadiusDistribution::RadiusDistribution(const SizeSettings& sizes) : curve_(readSizeCurve(sizes))
{
    smallest_ = curve_->smallest();
    largest_ = curve_->largest();
}

double RadiusDistribution::meanPower(int power) const
{
    if (curve_)
    {
        return curve_->meanPower(power);
    }
    if (equal())
    {
        return std::pow(largest_, power);
    }
    if (values_.empty())
    {
        return (std::pow(largest_, power + 1) - std::pow(smallest_, power + 1)) /
               ((power + 1) * (largest_ - smallest_));
    }
    double sum = 0;
    for (const double radius : values_)
    {
        sum += std::pow(radius, power);
    }
    return sum / static_cast<double>(values_.size());
}

double RadiusDistribution::draw(double uniform, double limit) const
{
    if (curve_)
    {
        const double below = limit < largest_ ? curve_->cumulative(limit, SizeCurve::kNumber) : 1;
        // Rounding may take the inverse of a share a little beyond where the share was taken.
        return std::max(smallest_, std::min(limit, curve_->quantile(uniform * below)));
    }
    if (values_.empty())
    {
        return smallest_ + uniform * (std::clamp(limit, smallest_, largest_) - smallest_);
    }
    const auto end = std::upper_bound(values_.begin(), values_.end(), limit);
    const auto among = std::max<std::ptrdiff_t>(1, end - values_.begin());
    return values_[static_cast<std::size_t>(uniform * static_cast<double>(among))];
}

std::vector<double> RadiusDistribution::distinct(std::size_t most) const
{
    if (equal())
    {
        return {largest_};
    }
    std::vector<double> different = curve_ ? curve_->distinct() : values_;
    different.erase(std::unique(different.begin(), different.end()), different.end());
    if (different.size() > most)
    {
        different.clear();
    }
    return different;
}

RadiusDistribution RadiusDistribution::inLargest() const
{
    RadiusDistribution scaled = *this;
    for (double& radius : scaled.values_)
    {
        radius /= largest_;
    }
    if (curve_)
    {
        scaled.curve_ = curve_->in(largest_);
    }
    scaled.smallest_ = smallest_ / largest_;
    scaled.largest_ = 1;
    return scaled;
}

} // namespace frostfill
