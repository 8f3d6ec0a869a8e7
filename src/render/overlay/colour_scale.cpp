// SPDX-License-Identifier: MIT
#include "render/overlay/colour_scale.hpp"

#include <frostfill/error.hpp>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>

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

/// Of frozen spheres that the column says nothing of: blue is a colour of the scale. Running and
/// discarded ones are as in other pictures.
constexpr Colour kResting = {138, 142, 146, 255};

/// Where spheres fall through a pile that grows evenly, 19 of 20 are seen slower than this share of
/// the speed of a fall through all of the object. (1.5 x - 0.5 x^3 = 0.95)
constexpr double kFastShare = 0.81;

/// Speeds are shown in metres a second.
constexpr std::string_view kSpeedUnit = "mesh unit/s";

const Column& colourColumn(const std::string& name)
{
    const Column* column = findColumn(name);
    if (column == nullptr || !column->colour)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("no column '{}' gives spheres their colours; choose among {}", name,
                                fmt::join(colourColumns(), ", ")));
    }
    return *column;
}

std::string titleOf(const Column& column)
{
    const std::string unit = column.unit == kSpeedUnit ? "m/s" : column.unit;
    return unit.empty() ? column.title : fmt::format("{} [{}]", column.title, unit);
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
    : column_(&colourColumn(settings.style.colourBy)), palette_(settings.style.palette),
      range_(settings.range), title_(titleOf(*column_)),
      groupsPerSet_(std::max(1U, settings.groupsPerSet)), unitsPerMetre_(settings.unitsPerMetre),
      up_(settings.up)
{
    if (column_->isCarried())
    {
        range_ = {column_->low, column_->high};
    }
    if (column_->scale == ColumnScale::fall)
    {
        range_ = {0, roundUp(kFastShare * range_.high)};
    }
    if (column_->scale == ColumnScale::depth && !vertices.empty())
    {
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& vertex : vertices)
        {
            box.extend(vertex);
        }
        range_ = {0, box.sizes().minCoeff() / 2};
    }
    if (column_->scale != ColumnScale::height || vertices.empty())
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
    // A snapshot made by hand need not have what no picture shows.
    const auto entry = [&](const auto& values)
    { return sphere < values.size() ? values[sphere] : std::decay_t<decltype(values[0])>(); };
    SphereRow row{.id = static_cast<std::uint32_t>(sphere),
                  .centre = Eigen::Vector3d::Zero(),
                  .radius = entry(snapshot.radii),
                  .state = snapshot.states[sphere],
                  .group = entry(snapshot.groups),
                  .speed = entry(snapshot.speeds),
                  .carried = snapshot.columns};
    row.set = row.group / groupsPerSet_;
    if (sphere < snapshot.centres.size())
    {
        row.centre = snapshot.centres[sphere].cast<double>() + snapshot.origin;
        row.height = up_.dot(row.centre) - foot_;
    }
    return row.value(*column_) / (column_->unit == kSpeedUnit ? unitsPerMetre_ : 1);
}

void SphereColours::requireIn(const Snapshot& snapshot) const
{
    if (column_->isCarried() && snapshot.values(*column_) == nullptr)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("the run was kept without the column {}: its spheres cannot be "
                                "coloured by it",
                                column_->name));
    }
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
    if (!speaksOf(snapshot.states[sphere]))
    {
        return otherColour(snapshot.states[sphere]);
    }
    const double width = range_.high - range_.low;
    const double shown = value(snapshot, sphere);
    return std::isnan(shown) ? otherColour(snapshot.states[sphere])
                             : scaleColour(width > 0 ? (shown - range_.low) / width : 0);
}

Colour SphereColours::ofSwatch(SphereState state) const
{
    if (!hasScale())
    {
        return ofState(state);
    }
    return speaksOf(state) ? scaleColour(0.5) : otherColour(state);
}

bool SphereColours::speaksOf(SphereState state) const
{
    return column_->of == ColumnOf::all ||
           (state == SphereState::running) == (column_->of == ColumnOf::running);
}

Colour SphereColours::otherColour(SphereState state) const
{
    return state == SphereState::frozen ? kResting : ofState(state);
}

} // namespace frostfill
