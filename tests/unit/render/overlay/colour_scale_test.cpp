// SPDX-License-Identifier: MIT
// Can everyone read the scale of colours, and does it grow as its numbers do?
#include "render/overlay/colour_scale.hpp"

#include "support/colour_vision.hpp"
#include "support/expect_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using namespace testing_support;
using test::expectError;

constexpr int kSteps = 16;

constexpr std::array kMaps = {ColourMap::viridis, ColourMap::cividis, ColourMap::plasma,
                              ColourMap::inferno, ColourMap::magma};

Eigen::Vector3d seen(const Eigen::Matrix3d& vision, double value,
                     ColourMap map = ColourMap::viridis)
{
    const Colour colour = scaleColour(value, map);
    return lab(vision * Eigen::Vector3d(linear(colour[0] / 255.0), linear(colour[1] / 255.0),
                                        linear(colour[2] / 255.0)));
}

TEST(ColourScale, GetsLighterForEveryKindOfColourVision)
{
    for (const ColourMap map : kMaps)
    {
        for (const Eigen::Matrix3d& vision : visions())
        {
            for (int i = 0; i < kSteps; ++i)
            {
                EXPECT_GT(seen(vision, (i + 1.0) / kSteps, map)[0],
                          seen(vision, double{1} * i / kSteps, map)[0])
                    << "map " << int(map) << " vision\n"
                    << vision << "\nstep " << i;
            }
        }
    }
}

TEST(ColourScale, HasTheColoursOfMatplotlib)
{
    // The lowest, the middle and the highest colour of matplotlib 3.6.
    const std::array<std::array<Colour, 3>, 5> expected = {
        {{{{68, 1, 84, 255}, {33, 145, 140, 255}, {253, 231, 37, 255}}},
         {{{0, 34, 78, 255}, {125, 124, 120, 255}, {254, 232, 56, 255}}},
         {{{13, 8, 135, 255}, {204, 71, 120, 255}, {240, 249, 33, 255}}},
         {{{0, 0, 4, 255}, {188, 55, 84, 255}, {252, 255, 164, 255}}},
         {{{0, 0, 4, 255}, {183, 55, 121, 255}, {252, 253, 191, 255}}}}};
    for (std::size_t map = 0; map < kMaps.size(); ++map)
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            const Colour colour = scaleColour(0.5 * static_cast<double>(i), kMaps[map]);
            for (std::size_t c = 0; c < 4; ++c)
            {
                EXPECT_NEAR(colour[c], expected[map][i][c], 1) << map << ' ' << i;
            }
        }
    }
}

TEST(ColourScale, CanBeSeenOnADarkBackground)
{
    RenderSettings settings;
    settings.style.palette = paletteOf(Look::dark);
    settings.style.colourBy = "radius";
    const Colour& ground = settings.style.palette.background;
    const auto lightness = [](const Colour& colour)
    {
        return lab(
            {linear(colour[0] / 255.0), linear(colour[1] / 255.0), linear(colour[2] / 255.0)})[0];
    };
    for (const ColourMap map : kMaps)
    {
        settings.style.colourMap = map;
        const SphereColours colours(settings, {});
        EXPECT_GT(lightness(colours.scaled(0)), lightness(ground) + 12) << int(map);
        EXPECT_EQ(colours.scaled(1), scaleColour(1, map));
    }
}

TEST(ColourScale, IsNoneByDefaultAndSpheresOfOneColourHaveNoMarks)
{
    RenderSettings settings;
    EXPECT_FALSE(SphereColours(settings, {}).hasScale());
    EXPECT_EQ(SphereColours(settings, {}).marked(SphereState::discarded), SphereState::discarded);
    Palette& palette = settings.style.palette;
    palette.running = palette.discarded = palette.frozen;
    EXPECT_EQ(SphereColours(settings, {}).marked(SphereState::discarded), SphereState::frozen);
}

TEST(ColourScale, EqualStepsAreSeenForEveryKindOfColourVision)
{
    for (const Eigen::Matrix3d& vision : visions())
    {
        for (int i = 0; i < kSteps; ++i)
        {
            const double step =
                (seen(vision, (i + 1.0) / kSteps) - seen(vision, double{1} * i / kSteps)).norm();
            EXPECT_GT(step, 3) << "vision\n" << vision << "\nstep " << i;
            EXPECT_LT(step, 20) << "vision\n" << vision << "\nstep " << i;
        }
    }
}

TEST(ColourScale, ValuesBeyondItBecomeItsEnds)
{
    EXPECT_EQ(scaleColour(-3), scaleColour(0));
    EXPECT_EQ(scaleColour(7), scaleColour(1));
    EXPECT_EQ(scaleColour(std::nan("")), scaleColour(0));
}

TEST(ColourScale, IsLabelledWithRoundNumbers)
{
    EXPECT_EQ(roundUp(0.037), 0.04);
    EXPECT_EQ(roundUp(5), 5);
    EXPECT_EQ(roundUp(91), 100);
    EXPECT_EQ(roundUp(0), 1);
    EXPECT_EQ(roundNumbers({0, 6}, false), (std::vector<double>{0, 2, 4, 6}));
    EXPECT_EQ(roundNumbers({0, 2.8}, false), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(roundNumbers({0, 31}, true), (std::vector<double>{0, 20}));
    EXPECT_EQ(roundNumbers({0, 1}, true), (std::vector<double>{0, 1}));
    EXPECT_EQ(roundNumbers({3, 3}, true), (std::vector<double>{3}));
}

TEST(ColourScale, OfSpeedsIsForWhatRunsAndCoversTheSpeedsThatAreSeen)
{
    RenderSettings settings;
    settings.style.colourBy = "speed";
    settings.range = {0, 6.2}; // of a fall through the object
    const SphereColours colours(settings, {});
    EXPECT_EQ(colours.range().high, 6);
    Snapshot snapshot;
    for (const SphereState state :
         {SphereState::running, SphereState::frozen, SphereState::discarded})
    {
        snapshot.states.push_back(state);
        snapshot.speeds.push_back(3);
    }
    EXPECT_EQ(colours.of(snapshot, 0), scaleColour(0.5));
    for (const std::size_t atRest : {1U, 2U})
    {
        const Colour grey = colours.of(snapshot, atRest);
        EXPECT_LT(*std::max_element(grey.begin(), grey.begin() + 3) -
                      *std::min_element(grey.begin(), grey.begin() + 3),
                  15);
        EXPECT_EQ(grey, colours.ofSwatch(snapshot.states[atRest]));
    }
}

TEST(ColourScale, OfContactsIsForWhatRestsAndEndsAtTheKissingNumber)
{
    RenderSettings settings;
    settings.style.colourBy = "contacts";
    settings.range = {0, 1}; // of nobody
    const SphereColours colours(settings, {});
    EXPECT_EQ(colours.range().low, 0);
    EXPECT_EQ(colours.range().high, 12);
    EXPECT_TRUE(colours.countsWhole());
    EXPECT_EQ(colours.title(), "Contacts");
    Snapshot snapshot;
    snapshot.states = {SphereState::running, SphereState::frozen, SphereState::discarded};
    expectError(
        ErrorCode::badData, [&] { colours.requireIn(snapshot); }, "without the column contacts");
    snapshot.columns = carriedColumns();
    snapshot.columns.front().bits = {0, 6, 12};
    colours.requireIn(snapshot);
    EXPECT_EQ(colours.of(snapshot, 0), settings.style.palette.running);
    EXPECT_EQ(colours.of(snapshot, 1), scaleColour(0.5));
    EXPECT_EQ(colours.of(snapshot, 2), scaleColour(1));
    EXPECT_EQ(colours.ofSwatch(SphereState::running), settings.style.palette.running);
    EXPECT_EQ(colours.ofSwatch(SphereState::frozen), scaleColour(0.5));
}

TEST(ColourScale, IsForSpheresThatHaveANumberAlone)
{
    RenderSettings settings;
    settings.style.colourBy = "local_fraction";
    const SphereColours colours(settings, {});
    Snapshot snapshot;
    snapshot.columns.emplace_back(*findColumn("local_fraction"));
    snapshot.resize(4);
    snapshot.states = {SphereState::frozen, SphereState::frozen, SphereState::frozen,
                       SphereState::running};
    snapshot.columns[0].set(0, std::nan(""));
    snapshot.columns[0].set(1, 0.4);
    snapshot.columns[0].set(2, 0.75);
    EXPECT_EQ(colours.of(snapshot, 1), scaleColour(0));
    EXPECT_EQ(colours.of(snapshot, 2), scaleColour(1));
    EXPECT_NE(colours.of(snapshot, 0), scaleColour(0));
    const Colour grey = colours.of(snapshot, 0);
    EXPECT_LT(std::abs(grey[0] - grey[2]), 20);
    EXPECT_EQ(colours.of(snapshot, 3), settings.style.palette.running);
}

TEST(ColourScale, OfDistancesFromWallsEndsWhereNoneIsFarther)
{
    RenderSettings settings;
    settings.style.colourBy = "wall_distance";
    const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {4, 1, 3}};
    EXPECT_EQ(SphereColours(settings, corners).range().high, 0.5);
}

TEST(ColourScale, OfRadiiReachesFromTheSmallestToTheLargest)
{
    RenderSettings settings;
    settings.style.colourBy = "radius";
    settings.range = {0.25, 0.75};
    const SphereColours colours(settings, {});
    Snapshot snapshot;
    snapshot.states.assign(3, SphereState::discarded);
    snapshot.radii = {0.25F, 0.5F, 0.75F};
    for (const std::size_t sphere : {0U, 1U, 2U})
    {
        EXPECT_EQ(colours.of(snapshot, sphere), scaleColour(0.5 * static_cast<double>(sphere)));
    }
    EXPECT_EQ(colours.title(), "Radius [mesh unit]");
}

TEST(ColourScale, RefusesAColumnThatGivesNoColours)
{
    for (const char* name : {"id", "colour"})
    {
        RenderSettings settings;
        settings.style.colourBy = name;
        expectError(
            ErrorCode::usage, [&] { const SphereColours colours(settings, {}); }, name, "contacts");
    }
}

/// A sphere of each state, in groups 0, 5 and 10, at heights 1, 2 and 4 above the foot of
/// `vertices`.
Snapshot threeSpheres()
{
    Snapshot snapshot;
    snapshot.origin = {1, 4, 0};
    snapshot.states = {SphereState::running, SphereState::frozen, SphereState::discarded};
    snapshot.groups = {0, 5, 10};
    snapshot.speeds = {3000, 0, 0};
    snapshot.radii = {1, 1, 1};
    snapshot.centres = {{0, -2, 0}, {7, -1, 3}, {-2, 1, 0}};
    return snapshot;
}
const std::vector<Eigen::Vector3d> kVertices = {{-9, 1, 0}, {9, 9, 0}};

std::vector<Colour> coloursBy(const std::string& by, ColourRange range = {})
{
    RenderSettings settings;
    settings.style.palette = paletteOf(Look::paper);
    settings.style.colourBy = by;
    settings.range = range;
    settings.groupsPerSet = 5;
    settings.unitsPerMetre = 1000;
    const SphereColours colours(settings, kVertices);
    const Snapshot snapshot = threeSpheres();
    return {colours.of(snapshot, 0), colours.of(snapshot, 1), colours.of(snapshot, 2)};
}

TEST(SphereColours, AreThoseOfThePaletteForStates)
{
    const Palette palette = paletteOf(Look::paper);
    EXPECT_EQ(coloursBy("state"),
              (std::vector<Colour>{palette.running, palette.frozen, palette.discarded}));
}

TEST(SphereColours, CountSetsAndGroupsFromTheLowEndOfTheScale)
{
    EXPECT_EQ(coloursBy("group", {0, 20}),
              (std::vector<Colour>{scaleColour(0), scaleColour(0.25), scaleColour(0.5)}));
    EXPECT_EQ(coloursBy("set", {0, 4}), // 5 groups each
              (std::vector<Colour>{scaleColour(0), scaleColour(0.25), scaleColour(0.5)}));
}

TEST(SphereColours, MeasureSpeedInMetresASecond)
{
    // 3000 units are 3 m; the scale ends at the round number from 81 % of a fall's speed on.
    EXPECT_EQ(coloursBy("speed", {0, 6 / 0.81})[0], scaleColour(0.5));
}

TEST(SphereColours, MeasureHeightFromTheFootOfTheObject)
{
    EXPECT_EQ(coloursBy("height"), (std::vector<Colour>{scaleColour(1 / 8.0), scaleColour(2 / 8.0),
                                                        scaleColour(4 / 8.0)}));
}

TEST(SphereColours, AreNamedWithTheirUnit)
{
    const auto title = [](const std::string& by)
    {
        RenderSettings settings;
        settings.style.colourBy = by;
        return SphereColours(settings, {}).title();
    };
    EXPECT_EQ(title("set"), "Set");
    EXPECT_EQ(title("group"), "Group");
    EXPECT_EQ(title("speed"), "Speed [m/s]");
    EXPECT_EQ(title("height"), "Height [mesh unit]");
}

} // namespace
} // namespace frostfill
