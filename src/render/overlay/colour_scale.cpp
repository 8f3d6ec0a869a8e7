// SPDX-License-Identifier: MIT
#include "render/overlay/colour_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

/// viridis at equal steps; between them straight lines are within 3 of 255.
constexpr std::array<std::array<double, 3>, 9> kScale = {{{68, 1, 84},
                                                          {71, 45, 123},
                                                          {59, 82, 139},
                                                          {44, 114, 142},
                                                          {33, 144, 140},
                                                          {39, 173, 129},
                                                          {93, 200, 99},
                                                          {170, 220, 50},
                                                          {253, 231, 37}}};

/// What rests has no speed worth a colour. Discarded spheres are as in other pictures.
constexpr Colour kResting = {138, 142, 146, 255};

/// Where spheres fall through a pile that grows evenly, 19 of 20 are seen slower than this share of
/// the speed of a fall through all of the object. (1.5 x - 0.5 x^3 = 0.95)
constexpr double kFastShare = 0.81;

const char* titleOf(ColourBy by)
{
    switch (by)
    {
    case ColourBy::set:
        return "Set";
    case ColourBy::group:
        return "Group";
    case ColourBy::speed:
        return "Speed [m/s]";
    case ColourBy::height:
        return "Height [mesh unit]";
    case ColourBy::state:
        break;
    }
    return "";
}

} // namespace

double roundUp(double value)
{
    if (!(value > 0) || !std::isfinite(value))
    {
        return 1;
    }
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 4.0, 5.0, 6.0, 8.0})
    {
        if (digit * power >= value * (1 - 1e-9))
        {
            return digit * power;
        }
    }
    return 10 * power;
}

std::vector<double> roundNumbers(const ColourRange& range, bool whole)
{
    const double width = range.high - range.low;
    if (!(width > 0))
    {
        return {range.low};
    }
    double step = roundUp(width / 3);
    if (whole)
    {
        step = std::max(1.0, std::ceil(step));
    }
    std::vector<double> numbers;
    for (double number = std::ceil(range.low / step - 1e-9) * step + 0.0; // not -0
         number <= range.high + 1e-9 * width; number += step)
    {
        numbers.push_back(number);
    }
    return numbers;
}

Colour scaleColour(double value)
{
    const double place =
        std::clamp(std::isnan(value) ? 0.0 : value, 0.0, 1.0) * (kScale.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kScale.size() - 2);
    const double share = place - static_cast<double>(below);
    Colour colour = {0, 0, 0, 255};
    for (std::size_t c = 0; c < 3; ++c)
    {
        colour[c] = static_cast<std::uint8_t>(
            std::lround(kScale[below][c] * (1 - share) + kScale[below + 1][c] * share));
    }
    return colour;
}

SphereColours::SphereColours(const RenderSettings& settings,
                             std::span<const Eigen::Vector3d> vertices)
    : by_(settings.style.colourBy), palette_(settings.style.palette), range_(settings.range),
      title_(titleOf(by_)), groupsPerSet_(std::max(1U, settings.groupsPerSet)),
      unitsPerMetre_(settings.unitsPerMetre), up_(settings.up)
{
    if (by_ == ColourBy::speed)
    {
        range_ = {0, roundUp(kFastShare * range_.high)};
    }
    if (by_ != ColourBy::height || vertices.empty())
    {
        return;
    }
    double top = -std::numeric_limits<double>::infinity();
    foot_ = -top;
    for (const Eigen::Vector3d& vertex : vertices)
    {
        foot_ = std::min(foot_, up_.dot(vertex));
        top = std::max(top, up_.dot(vertex));
    }
    range_ = {0, top - foot_};
}

double SphereColours::value(const Snapshot& snapshot, std::size_t sphere) const
{
    switch (by_)
    {
    case ColourBy::set:
        return snapshot.groups[sphere] / groupsPerSet_;
    case ColourBy::group:
        return snapshot.groups[sphere];
    case ColourBy::speed:
        return sphere < snapshot.speeds.size()
                   ? static_cast<double>(snapshot.speeds[sphere]) / unitsPerMetre_
                   : 0;
    case ColourBy::height:
        return up_.dot(snapshot.centres[sphere].cast<double>() + snapshot.origin) - foot_;
    case ColourBy::state:
        break;
    }
    return 0;
}

Colour SphereColours::ofState(SphereState state) const
{
    return state == SphereState::running  ? palette_.running
           : state == SphereState::frozen ? palette_.frozen
                                          : palette_.discarded;
}

Colour SphereColours::of(const Snapshot& snapshot, std::size_t sphere) const
{
    if (!hasScale())
    {
        return ofState(snapshot.states[sphere]);
    }
    if (by_ == ColourBy::speed && snapshot.states[sphere] != SphereState::running)
    {
        return restingColour(snapshot.states[sphere]);
    }
    const double width = range_.high - range_.low;
    return scaleColour(width > 0 ? (value(snapshot, sphere) - range_.low) / width : 0);
}

Colour SphereColours::ofSwatch(SphereState state) const
{
    if (by_ == ColourBy::speed && state != SphereState::running)
    {
        return restingColour(state);
    }
    return hasScale() ? scaleColour(0.5) : ofState(state);
}

Colour SphereColours::restingColour(SphereState state) const
{
    return state == SphereState::frozen ? kResting : palette_.discarded;
}

} // namespace frostfill
