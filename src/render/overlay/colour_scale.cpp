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

/// By ColourMap, 0xRRGGBB at equal steps; between them straight lines are within 11 of 255.
constexpr std::size_t kSteps = 16;
constexpr std::array<std::array<std::uint32_t, kSteps + 1>, 5> kMaps = {
    {{0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d, 0x2c728e, 0x26818e, 0x21908c,
      0x1f9f88, 0x28ae80, 0x3ebc74, 0x5dc963, 0x82d34c, 0xabdc32, 0xd5e21a, 0xfde725},
     {0x00224e, 0x002e6a, 0x1a386f, 0x32436d, 0x434e6c, 0x52596d, 0x61656f, 0x6f7073, 0x7c7b78,
      0x8b8778, 0x9b9376, 0xaba072, 0xbbad6c, 0xccba64, 0xddc958, 0xefd748, 0xfee838},
     {0x0d0887, 0x310596, 0x4c02a1, 0x6600a7, 0x7e03a8, 0x9511a2, 0xa92396, 0xbb3587, 0xcb4778,
      0xd9596a, 0xe66c5c, 0xf07f4f, 0xf89441, 0xfdab33, 0xfdc328, 0xf9dd25, 0xf0f921},
     {0x000004, 0x0b0724, 0x210c4a, 0x3c0965, 0x57106d, 0x70196e, 0x89226a, 0xa32b61, 0xbb3755,
      0xd14644, 0xe35932, 0xf1711e, 0xf98d0a, 0xfcab0f, 0xf9ca32, 0xf2e865, 0xfcffa4},
     {0x000004, 0x0a0822, 0x1d1146, 0x36106a, 0x50127c, 0x691c81, 0x822681, 0x9c2e7f, 0xb63779,
      0xcf4170, 0xe65163, 0xf5695c, 0xfb8761, 0xfea571, 0xfec387, 0xfde0a2, 0xfcfdbf}}};

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
    const Column* column = findColumn(name == "auto" ? "state" : name);
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

ColourRange heightsOf(std::span<const Eigen::Vector3d> vertices, const Eigen::Vector3d& up)
{
    ColourRange heights = {std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()};
    for (const Eigen::Vector3d& vertex : vertices)
    {
        heights.low = std::min(heights.low, up.dot(vertex));
        heights.high = std::max(heights.high, up.dot(vertex));
    }
    return heights;
}

Colour scaleColour(double value, ColourMap map)
{
    const auto& colours = kMaps[static_cast<std::size_t>(map)];
    const double place = std::clamp(std::isnan(value) ? 0.0 : value, 0.0, 1.0) * kSteps;
    const auto below = std::min(static_cast<std::size_t>(place), kSteps - 1);
    const double share = place - static_cast<double>(below);
    Colour colour = {0, 0, 0, 255};
    for (std::size_t c = 0; c < 3; ++c)
    {
        const auto channel = [&](std::uint32_t rgb) { return double(rgb >> (16 - 8 * c) & 255); };
        colour[c] = static_cast<std::uint8_t>(std::lround(channel(colours[below]) * (1 - share) +
                                                          channel(colours[below + 1]) * share));
    }
    return colour;
}

bool isDark(const Colour& background)
{
    return background[0] + background[1] + background[2] < 3 * 96;
}

bool hasOneColour(const Palette& palette)
{
    return palette.running == palette.frozen && palette.frozen == palette.discarded;
}

double scaleStart(const Colour& background)
{
    return isDark(background) ? 0.25 : 0;
}

SphereColours::SphereColours(const RenderSettings& settings,
                             std::span<const Eigen::Vector3d> vertices)
    : column_(&colourColumn(settings.style.colourBy)), palette_(settings.style.palette),
      map_(settings.style.colourMap), range_(settings.range), title_(titleOf(*column_)),
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
    if (column_->scale == ColumnScale::height && !vertices.empty())
    {
        const auto [foot, top] = heightsOf(vertices, up_);
        foot_ = foot;
        range_ = {0, top - foot};
    }
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

SphereState SphereColours::marked(SphereState state) const
{
    return !hasScale() && hasOneColour(palette_) ? SphereState::frozen : state;
}

Colour SphereColours::of(const Snapshot& snapshot, std::size_t sphere) const
{
    const SphereState state = snapshot.states[sphere];
    if (!hasScale())
    {
        return ofState(state);
    }
    const double width = range_.high - range_.low;
    const double shown = speaksOf(state) ? value(snapshot, sphere) : std::nan("");
    return std::isnan(shown) ? otherColour(state)
                             : scaled(width > 0 ? (shown - range_.low) / width : 0);
}

Colour SphereColours::ofSwatch(SphereState state) const
{
    return !hasScale() ? ofState(state) : speaksOf(state) ? scaled(0.5) : otherColour(state);
}

Colour SphereColours::scaled(double share) const
{
    const double start = scaleStart(palette_.background);
    return scaleColour(start + (1 - start) * std::clamp(share, 0.0, 1.0), map_);
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
