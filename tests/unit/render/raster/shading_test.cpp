// SPDX-License-Identifier: MIT
// The text of the shaders as C++, against other ways to say the same in double precision.
#include "render/raster/lanes/shading.hpp"

#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

using lanes::all;
using testing_support::Numbers;

/// Whether a point of stripes is dark, without smoothing.
bool isDark(double phase, double share)
{
    return std::abs(phase - std::floor(phase) - 0.5) > 0.5 * (1 - share);
}

TEST(Shading, StripesAreTheMeanOverAPixelUntilTheyAreTooFine)
{
    constexpr int kSteps = 4000;
    for (const double share : {0.34, 0.4})
    {
        for (const double width : {0.02, 0.1, 0.25})
        {
            for (double phase = -2; phase < 2; phase += 0.0137)
            {
                int dark = 0;
                for (int i = 0; i < kSteps; ++i)
                {
                    dark += isDark(phase + width * ((i + 0.5) / kSteps - 0.5), share) ? 1 : 0;
                }
                const float drawn =
                    lanes::stripes(all(static_cast<float>(phase)), static_cast<float>(share),
                                   static_cast<float>(width))[0];
                EXPECT_NEAR(drawn, static_cast<double>(dark) / kSteps, 0.003);
            }
        }
        EXPECT_FLOAT_EQ(lanes::stripes(all(0.3F), static_cast<float>(share), 0.7F)[3],
                        static_cast<float>(share));
    }
}

TEST(Shading, ARayMeetsWhatACutLeaves)
{
    Numbers numbers;
    const auto between = [&](double low, double high)
    { return low + (high - low) * numbers.next(); };
    std::array<int, 4> seen{};
    for (int k = 0; k < 2000; ++k)
    {
        const std::array<double, 2> start = {between(-1, 2), between(-1, 2)};
        const std::array<double, 2> growth = {between(-2, 2), between(-2, 2)};
        const double enter = between(0.2, 0.8);
        const double leave = enter + between(0.1, 1);
        // In small steps along the ray.
        constexpr int kSteps = 20000;
        const double step = (leave - enter) / kSteps;
        int met = 0;
        const auto depth = [&](std::size_t plane)
        { return start[plane] + (enter + met * step) * growth[plane]; };
        while (met < kSteps && depth(0) > 0 && depth(1) > 0)
        {
            ++met;
        }
        const auto one = [](double value) { return all(static_cast<float>(value)); };
        const lanes::CutMeeting own = lanes::meetCut(one(start[0]), one(growth[0]), one(start[1]),
                                                     one(growth[1]), one(enter), one(leave));
        if (met == kSteps)
        {
            EXPECT_EQ(own.isThere[2], 0);
            ++seen[0];
            continue;
        }
        ASSERT_NE(own.isThere[2], 0);
        EXPECT_EQ(own.capped[2] != 0, met > 0);
        EXPECT_NEAR(own.t[2], enter + met * step, 2 * step + 1e-5);
        if (met > 0)
        {
            EXPECT_EQ(own.onSecond[2] != 0, depth(1) <= 0);
        }
        ++seen[met == 0 ? 1 : own.onSecond[2] != 0 ? 2 : 3];
    }
    for (const int count : seen)
    {
        EXPECT_GT(count, 50) << "the rays prove little";
    }
}

TEST(Shading, ACutEndsInItsMiddleAndItsLineBesideIt)
{
    for (float away = -2.97F; away < 3; away += 0.1F)
    {
        // The share of a pixel on this side of the cut.
        int left = 0;
        constexpr int kSteps = 1000;
        for (int i = 0; i < kSteps; ++i)
        {
            left += away + (i + 0.5) / kSteps - 0.5 < 0 ? 1 : 0;
        }
        EXPECT_NEAR(lanes::leftOfCut(all(away))[5], static_cast<double>(left) / kSteps, 0.0015);
        const float line = lanes::lineOfCut(all(away), 1)[5];
        EXPECT_EQ(line > 0.8F, away > -1) << away;
        EXPECT_EQ(line > 0, away > -2) << away;
    }
}

TEST(Shading, ACutOfASphereIsPaleWithADarkRim)
{
    shading::SphereLook look{{200, 100, 40}, {}, 0.02F, 0, 0, 0, 0};
    const auto at = [&](float fromMiddle)
    {
        const float height = 0.6F; // of the centre above the cut, whose disc has a radius of 0.8
        const float squared = fromMiddle * fromMiddle + height * height;
        return lanes::onCut(look, all(1), all(squared), all(height * height), all(0));
    };
    const lanes::Vectors middle = at(0);
    EXPECT_NEAR(middle.y[0] / middle.x[0], (100 + 0.34 * 155) / (200 + 0.34 * 55), 1e-3);
    EXPECT_NEAR(at(0.7F).x[0], middle.x[0], 1e-3);
    EXPECT_NEAR(at(0.795F).x[0], 0.3 * middle.x[0], 1e-2);
    look.ring = 0.8F; // of a sphere that runs
    EXPECT_NEAR(at(0.7F).x[0], 0.2 * middle.x[0], 1e-2);
    EXPECT_NEAR(at(0).x[0], middle.x[0], 1e-3);
}

TEST(Shading, LinesLieOverTheFilmAndInPrintWithinIt)
{
    for (float film = 0; film <= 0.85F; film += 0.05F)
    {
        for (float line = 0; line <= 1; line += 0.05F)
        {
            const lanes::Film over = lanes::lineInFilm(false, all(film), all(line));
            EXPECT_NEAR(over.film[0] + over.line[0], 1 - (1 - film) * (1 - line), 1e-6);
            EXPECT_FLOAT_EQ(over.line[0], line);
            const lanes::Film print = lanes::lineInFilm(true, all(film), all(line));
            EXPECT_NEAR(print.film[0] + print.line[0], std::max(film, line), 1e-6);
            // The colour is mixed in the shares of the line.
            EXPECT_NEAR(print.line[0], line * std::max(film, line), 1e-6);
        }
    }
}

TEST(Shading, ALampIsHiddenByWhatIsBeforeItAndByNothingElse)
{
    const auto left = [](double ahead, double beside, float radius)
    {
        return lanes::lampPast(all(static_cast<float>(ahead)), radius,
                               all(static_cast<float>(ahead * ahead + beside * beside)))[0];
    };
    EXPECT_EQ(left(3, 0, 2), 0);
    EXPECT_EQ(left(-3, 0, 2), 1);
    EXPECT_EQ(left(3, 6, 2), 1);
    // Half of the lamp is hidden where the ray to its middle grazes the neighbour.
    EXPECT_NEAR(left(3, 2, 2), 0.5, 1e-5);
    // A lamp of half width 0.3 is seen from 3 away behind a strip of 2 * 0.9.
    EXPECT_NEAR(left(3, 2 + 0.89, 2), 1, 0.02);
    EXPECT_LT(left(3, 2 + 0.6, 2), 0.9);
}

TEST(Shading, SkyIsHiddenMoreTheMoreANeighbourRisesAndTheLargerItIs)
{
    const auto left = [](double cosine, float radius)
    {
        // They touch: the way from the own centre is 1 + radius long.
        const double along = cosine * (1 + double{radius});
        const double squared = (1 + double{radius}) * (1 + double{radius}) + 1 - 2 * along;
        return lanes::skyPast(all(static_cast<float>(along)), radius,
                              all(static_cast<float>(squared)))[0];
    };
    EXPECT_NEAR(left(1, 1), 0.15, 1e-5); // where they touch
    EXPECT_EQ(left(-1, 1), 1);
    float before = 0;
    for (double cosine = 1; cosine >= -1; cosine -= 0.05)
    {
        EXPECT_GE(left(cosine, 1), before);
        before = left(cosine, 1);
        EXPECT_GE(left(cosine, 0.5F), left(cosine, 1));
    }
}

TEST(Shading, DiscardedPolygonsHaveNoPlainEdges)
{
    EXPECT_EQ(lanes::paintOf(0.5F, true, true).ofEdges, 0);
    EXPECT_EQ(lanes::paintOf(0.5F, false, true).ofEdges, 1);
    const lanes::Floats none = lanes::edgeStrength(all(lanes::kPlain), all(0), all(1));
    const lanes::Floats crease = lanes::edgeStrength(all(0.5F), all(0), all(1));
    EXPECT_EQ(none[0], 0);
    EXPECT_EQ(crease[0], 0.5F);
    EXPECT_EQ(lanes::edgeStrength(all(1), all(0), all(0.25F))[0], 0.25F * lanes::kStrong);
}

TEST(Shading, MarksTellStatesApartAndStudioHasNoHatch)
{
    const auto look = [](SphereState state, bool studio, bool print)
    {
        return lanes::lookOf({200, 100, 50}, lanes::marksOf(static_cast<std::uint32_t>(state)), 1,
                             0, {}, 0.01F, 1, studio, print);
    };
    const shading::SphereLook running = look(SphereState::running, false, false);
    EXPECT_GT(running.gloss, 100);
    EXPECT_GT(running.ring, 0.5F);
    EXPECT_EQ(look(SphereState::running, false, true).gloss, 0); // print has no gloss
    EXPECT_GT(look(SphereState::running, true, false).gloss, 100);
    const shading::SphereLook frozen = look(SphereState::frozen, false, false);
    EXPECT_EQ(frozen.gloss + frozen.ring + frozen.hatch, 0);
    EXPECT_EQ(frozen.tint, glm::vec3(200, 100, 50));
    EXPECT_FLOAT_EQ(look(SphereState::discarded, false, false).hatch, 0.42F);
    EXPECT_EQ(look(SphereState::discarded, true, false).hatch, 0);
}

} // namespace
} // namespace frostfill
