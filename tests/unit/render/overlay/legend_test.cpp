// SPDX-License-Identifier: MIT
#include "render/overlay/legend.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace frostfill
{
namespace
{

RenderSettings usual()
{
    RenderSettings settings;
    settings.title = "a title";
    return settings;
}

Legend legendOf(const RenderSettings& settings)
{
    return {settings, 100, SphereColours(settings, {})};
}

/// Five counts that differ.
Snapshot someState()
{
    Snapshot snapshot;
    snapshot.running = 3;
    snapshot.frozen = 50;
    snapshot.discarded = 700;
    snapshot.discardedPolygons = 11;
    snapshot.time = 1.25;
    snapshot.step = 77;
    snapshot.set = 4;
    return snapshot;
}

/// What a legend says, from the top.
std::string textOf(const Legend& legend)
{
    std::map<double, std::vector<Legend::Piece>> lines; // from the top
    for (const Legend::Piece& piece : legend.pieces(someState()))
    {
        lines[piece.baseline].push_back(piece);
    }
    std::string text;
    for (auto& [baseline, pieces] : lines)
    {
        std::sort(pieces.begin(), pieces.end(),
                  [](const auto& a, const auto& b) { return a.x < b.x; });
        for (const Legend::Piece& piece : pieces)
        {
            text += piece.text.empty() ? "" : piece.text + " ";
        }
        text.back() = '\n';
    }
    return text;
}

TEST(Legend, HasEachNumberBesideItsName)
{
    EXPECT_EQ(textOf(legendOf(usual())), "a title\n"
                                         "Spheres\nrunning 3\nfrozen 50\ndiscarded 700\n"
                                         "Polygons\nactive 89\ndiscarded 11\n"
                                         "set 4  step 77\n1.250 s\n");
}

TEST(Legend, CountsAllWhereStatesHaveOneColour)
{
    RenderSettings settings = usual();
    Palette& palette = settings.style.palette;
    palette.running = palette.discarded = palette.frozen;
    const Legend legend = legendOf(settings);
    EXPECT_EQ(textOf(legend), "a title\nspheres 753\npolygons 100\nset 4  step 77\n1.250 s\n");
    EXPECT_TRUE(legend.spheres().empty());
}

TEST(Legend, HasASwatchOfEachStateBesideItsName)
{
    const Legend legend = legendOf(usual());
    const std::vector<Legend::Piece> pieces = legend.pieces(someState());
    // What is written in the line that the swatch stands in.
    const auto nameBeside = [&](const Legend::Swatch& swatch)
    {
        const auto found = std::find_if(pieces.begin(), pieces.end(),
                                        [&](const Legend::Piece& piece)
                                        {
                                            return piece.kind == Legend::Piece::Kind::text &&
                                                   piece.baseline > swatch.y &&
                                                   piece.baseline - swatch.y < swatch.halfSize;
                                        });
        return found == pieces.end() ? "" : found->text;
    };
    const std::map<std::string, SphereState> spheres = {{"running", SphereState::running},
                                                        {"frozen", SphereState::frozen},
                                                        {"discarded", SphereState::discarded}};
    const std::map<std::string, PolygonState> polygons = {{"active", PolygonState::active},
                                                          {"discarded", PolygonState::discarded}};
    ASSERT_EQ(legend.spheres().size(), spheres.size());
    for (const Legend::Swatch& swatch : legend.spheres())
    {
        EXPECT_EQ(swatch.state, static_cast<int>(spheres.at(nameBeside(swatch))));
    }
    ASSERT_EQ(legend.polygons().size(), polygons.size());
    for (const Legend::Swatch& swatch : legend.polygons())
    {
        EXPECT_EQ(swatch.state, static_cast<int>(polygons.at(nameBeside(swatch))));
    }
}

TEST(Legend, OfAPictureThatIsMadeSmallIsAsMuchLarger)
{
    RenderSettings settings = usual();
    settings.size = {480, 400}; // in which type is as small as can be read
    const Legend one = legendOf(settings);
    ASSERT_TRUE(one.visible());
    settings.size = {3 * settings.size.width, 3 * settings.size.height};
    settings.supersample = 3;
    const Legend three = legendOf(settings);
    EXPECT_NEAR(three.width(), 3 * one.width(), 0.01 * three.width());
    EXPECT_NEAR(three.height(), 3 * one.height(), 0.01 * three.height());
}

TEST(Legend, HasTheScaleOfColoursFromLowToHigh)
{
    RenderSettings settings = usual();
    settings.style.colourBy = "group";
    settings.range = {0, 8};
    const Legend legend = legendOf(settings);
    Image image;
    image.width = settings.size.width;
    image.height = settings.size.height;
    image.channels = 3;
    image.pixels.assign(static_cast<std::size_t>(3 * image.width * image.height), 0);
    const std::vector<Legend::Piece> pieces = legend.pieces(someState());
    const auto bar = std::find_if(pieces.begin(), pieces.end(),
                                  [](const Legend::Piece& piece)
                                  { return piece.kind == Legend::Piece::Kind::bar; });
    ASSERT_NE(bar, pieces.end());
    legend.draw(image, *bar);
    const PixelRectangle place = legend.bounds(*bar); // from the lower left corner
    const int y = image.height - 1 - place.bottom;
    for (int x = place.left; x < place.right; ++x)
    {
        const Colour colour = scaleColour(double{1} * (x - place.left) / (place.width() - 1));
        ASSERT_TRUE(std::equal(colour.begin(), colour.begin() + 3, image.at(x, y))) << x;
    }
    // The number in the middle stands under its colour.
    const auto label =
        std::find_if(bar, pieces.end(), [](const auto& piece) { return piece.text == "4"; });
    ASSERT_NE(label, pieces.end());
    const PixelRectangle under = legend.bounds(*label);
    EXPECT_NEAR((under.left + under.right) / 2.0, (place.left + place.right) / 2.0, 2);
}

} // namespace
} // namespace frostfill
