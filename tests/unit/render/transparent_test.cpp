// SPDX-License-Identifier: MIT
// Pictures without a background, over whatever they are laid on.
#include "support/pictures.hpp"
#include "unit/render/looks_samples.hpp"

#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace frostfill
{
namespace
{

using namespace test;

TEST(Looks, TransparentBackgroundIsRightOverWhiteAndOverBlack)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    const Snapshot snapshot = pack(mesh, 40, 0.15);
    RenderSettings settings = smallSettings();
    settings.style.legend = false;
    for (const int ground : {255, 0})
    {
        const auto grey = static_cast<std::uint8_t>(ground);
        settings.style.palette.background = {grey, grey, grey, 255};
        const Image opaque = draw(mesh, settings, snapshot);
        settings.style.palette.background[3] = 0;
        const Image clear = draw(mesh, settings, snapshot);
        ASSERT_EQ(clear.channels, 4);
        EXPECT_EQ(clear.at(0, 0)[3], 0);
        const ImageDifference difference = compareImages(over(clear, ground), opaque);
        EXPECT_LE(difference.largest, 3) << "over " << ground;
    }
}

TEST(Looks, NoBackgroundIsClearOutsideSolidWithinAndGivesTheOpaquePictureOverItsColour)
{
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    const Snapshot snapshot = pack(mesh, 60, 0.15);
    for (const Look look : {Look::clean, Look::paper, Look::dark, Look::studio})
    {
        RenderSettings settings = smallSettings();
        settings.style.look = look;
        settings.style.palette = paletteOf(look);
        const Colour ground = settings.style.palette.background;
        const Image opaque = draw(mesh, settings, snapshot);
        settings.style.palette.background[3] = 0;
        const Image clear = draw(mesh, settings, snapshot);
        ASSERT_EQ(clear.channels, 4);
        EXPECT_EQ(clear.at(0, 0)[3], 0);
        double squares = 0;
        int largest = 0;
        int solid = 0;
        int apartByMore = 0; // layers of the shell are rounded one by one
        for (int y = 0; y < clear.height; ++y)
        {
            for (int x = 0; x < clear.width; ++x)
            {
                const auto* pixel = clear.at(x, y);
                solid += pixel[3] == 255 ? 1 : 0;
                for (std::size_t c = 0; c < 3; ++c)
                {
                    const int laid =
                        (pixel[c] * pixel[3] + ground[c] * (255 - pixel[3]) + 127) / 255;
                    const int apart = std::abs(laid - int{opaque.at(x, y)[c]});
                    largest = std::max(largest, apart);
                    squares += apart * apart;
                    apartByMore += apart > 1 ? 1 : 0;
                }
            }
        }
        EXPECT_GT(solid, clear.width * clear.height / 20);
        EXPECT_LE(largest, 4) << static_cast<int>(look);
        EXPECT_LE(apartByMore, 3 * clear.width * clear.height / 100) << static_cast<int>(look);
        EXPECT_LE(std::sqrt(squares / (3.0 * clear.width * clear.height)), 0.5);
    }
}

TEST(Looks, TextOnNothingKeepsItsColourAndIsOutlinedInTheOther)
{
    RenderSettings settings = smallSettings();
    settings.size = {1280, 720};
    settings.style.palette.background[3] = 0;
    settings.style.palette.text = {90, 10, 20, 255};
    settings.style.shell = false;
    settings.title = "frost";
    const Image image = draw(boxMesh({1, 1, 1}), settings, Snapshot{});
    int ink = 0;
    int outline = 0;
    for (int y = 0; y < 45; ++y)
    {
        for (int x = 0; x < 120; ++x)
        {
            const auto* pixel = image.at(x, y);
            if (pixel[3] < 250)
            {
                continue;
            }
            ink += std::abs(pixel[0] - 90) < 6 && pixel[1] < 16 ? 1 : 0;
            outline += pixel[0] > 250 && pixel[1] > 250 ? 1 : 0;
        }
    }
    EXPECT_GT(ink, 15);
    EXPECT_GT(outline, 30);
}
} // namespace
} // namespace frostfill
