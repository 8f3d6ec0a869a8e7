// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/renderer.hpp>
#include <frostfill/snapshot.hpp>

#include <span>
#include <string>
#include <vector>

namespace frostfill
{

/// A scale at 0..1 (values beyond become the ends): its lightness grows evenly, for every kind of
/// colour vision and in grey. [van der Walt & Smith 2015]
[[nodiscard]] Colour scaleColour(double value, ColourMap map = ColourMap::viridis);

[[nodiscard]] bool isDark(const Colour& background);

/// Whether spheres of all states have one colour.
[[nodiscard]] bool hasOneColour(const Palette& palette);

/// Where scales begin on a background: the darkest colours cannot be seen on a dark one.
[[nodiscard]] double scaleStart(const Colour& background);

/// The least number of the form 1, 2, 4, 5, 6, 8 times a power of ten that is not below a value; 1
/// for what is not positive.
[[nodiscard]] double roundUp(double value);

/// Some round numbers in a range, ascending: what to write beside its scale. `whole`: no fractions.
[[nodiscard]] std::vector<double> roundNumbers(const ColourRange& range, bool whole);

/// From the lowest point to the highest, along `up`.
[[nodiscard]] ColourRange heightsOf(std::span<const Eigen::Vector3d> vertices,
                                    const Eigen::Vector3d& up);

/// What colours of spheres mean in one picture.
class SphereColours
{
public:
    /// `vertices` are the mesh's. Throws Error usage for a column that gives no colours.
    SphereColours(const RenderSettings& settings, std::span<const Eigen::Vector3d> vertices);

    /// Throws Error badData for a snapshot that does not carry the column.
    void requireIn(const Snapshot& snapshot) const;
    [[nodiscard]] Colour of(const Snapshot& snapshot, std::size_t sphere) const;
    /// The state that the marks of a sphere show: all are plain where all have one colour.
    [[nodiscard]] SphereState marked(SphereState state) const;
    /// Of a sphere in the legend, where a state is shown by its marks alone unless colours mean it.
    [[nodiscard]] Colour ofSwatch(SphereState state) const;

    [[nodiscard]] Colour scaled(double share) const;
    [[nodiscard]] bool hasScale() const { return column_->name != "state"; }
    [[nodiscard]] const ColourRange& range() const { return range_; }
    [[nodiscard]] bool countsWhole() const { return column_->isWhole(); }
    [[nodiscard]] const Column& column() const { return *column_; }
    [[nodiscard]] const std::string& title() const { return title_; } ///< with the unit

private:
    [[nodiscard]] Colour ofState(SphereState state) const;
    /// Of a sphere that the column says nothing of.
    [[nodiscard]] Colour otherColour(SphereState state) const;
    [[nodiscard]] bool speaksOf(SphereState state) const;
    [[nodiscard]] double value(const Snapshot& snapshot, std::size_t sphere) const;

    const Column* column_;
    Palette palette_;
    ColourMap map_;
    ColourRange range_;
    std::string title_;
    std::uint32_t groupsPerSet_;
    double unitsPerMetre_;
    Eigen::Vector3d up_;
    double foot_ = 0; ///< [mesh unit] of the object, along `up_`
};

} // namespace frostfill
