// SPDX-License-Identifier: MIT
#include "run/run_files.hpp"

#include <frostfill/render_run.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace frostfill
{
namespace
{

/// A run of 1,000 spheres without a fault.
FillResult goodResult()
{
    FillResult result;
    result.spheres = 1000;
    result.quality.maxOverlap = 1e-9;
    result.quality.maxWallOverlap = 1e-7;
    result.quality.unsupported = 5;
    return result;
}

std::string faultOf(const FillResult& result, Preset preset = Preset::fast)
{
    return findFault(presetScene(preset, "cube"), result, false).value_or("");
}

bool contains(const std::string& text, const std::string& word)
{
    return text.find(word) != std::string::npos;
}

TEST(Verdict, FindsNoFaultInAGoodRun)
{
    EXPECT_EQ(faultOf(goodResult()), "");
}

TEST(Verdict, BlamesOverlapsBeyondAMillionthOfTheRadius)
{
    FillResult result = goodResult();
    result.quality.maxOverlap = 1.1e-6;
    EXPECT_TRUE(
        contains(faultOf(result), "overlap by 1.1e-06 of a radius, where 1e-06 is allowed"));
    result = goodResult();
    result.quality.maxWallOverlap = 1.1e-6;
    EXPECT_TRUE(contains(faultOf(result), "deep in a wall"));
}

TEST(Verdict, SaysWhatHasNotSettled)
{
    FillResult result = goodResult();
    SettlingReport& settling = result.quality.settling.emplace();
    settling.missing = 9.3;
    EXPECT_TRUE(contains(faultOf(result), "miss 9.3 of a sphere's weight, where 0.1 is allowed"));
    settling.missing = 0.07;
    settling.moving = 3;
    settling.mayMove = 2;
    EXPECT_TRUE(
        contains(faultOf(result), "more than 0.02 of the weight of 3 spheres, where 2 may be so"));
    settling.overlap = 0.0043;
    result.quality.maxWallOverlap = 0.0043;
    EXPECT_TRUE(contains(faultOf(result), "overlaps a wall by 0.0043 of a radius, where 1e-08"));
    result.quality.maxOverlap = 0.005;
    EXPECT_TRUE(contains(faultOf(result), "overlaps another by"));
}

/// What is wrong where the bulk has packed to this.
std::string faultOfFraction(std::optional<double> asked, std::optional<double> reached,
                            Motion motion = Motion::granular)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.motion.mode = motion;
    scene.rest.friction = 0.3;
    scene.rest.fraction = asked;
    FillResult result = goodResult();
    result.quality.settling.emplace();
    result.quality.settling->settled = true;
    result.quality.settling->fraction = reached;
    return findFault(scene, result, false).value_or("");
}

TEST(Verdict, BlamesAFractionThatIsNotReached)
{
    EXPECT_EQ(faultOfFraction(0.6, 0.6019), "");
    EXPECT_EQ(faultOfFraction(0.6, 0.5981), "");
    EXPECT_TRUE(contains(faultOfFraction(0.6, 0.5979), "flows no denser"));
    const std::string denser = faultOfFraction(0.6, 0.6343, Motion::skip);
    EXPECT_TRUE(contains(denser, "packs to 0.6343, where 0.6 is asked to within 0.002"));
    EXPECT_TRUE(contains(denser, "try --motion granular"));
    // Another pile may be looser.
    EXPECT_TRUE(contains(faultOfFraction(0.59, 0.5926), "nothing loosens this pile"));
    EXPECT_TRUE(contains(faultOfFraction(0.59, 0.5926), "another --seed or more --friction"));
    EXPECT_EQ(faultOfFraction(0.6, 0.6343).find("granular"), std::string::npos);
    EXPECT_TRUE(contains(faultOfFraction(0.6, {}), "cannot be measured"));
    for (const auto end : {RestSettings::kLoosest, RestSettings::kDensest})
    {
        EXPECT_EQ(faultOfFraction(end, 0.62), "");
    }
    EXPECT_EQ(faultOfFraction({}, {}), "");
}

TEST(Verdict, RecommendsNothingThatWasDone)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.motion.mode = Motion::descend;
    FillResult result = goodResult();
    result.quality.unsupported = 100;
    EXPECT_FALSE(contains(*findFault(scene, result, false), "--motion descend"));
    result.overfull = true;
    EXPECT_FALSE(contains(*findFault(scene, result, false), "preset fast"));
}

TEST(Verdict, BlamesMoreSpheresThanTheVolumeHolds)
{
    FillResult result = goodResult();
    result.overfull = true;
    EXPECT_TRUE(contains(faultOf(result), "stopped after 1000 spheres, which take more than"));
}

TEST(Verdict, BlamesPositionsThatAreNotFinite)
{
    FillResult result = goodResult();
    result.quality.notFinite = 1;
    for (const Preset preset : {Preset::fast, Preset::paper})
    {
        EXPECT_TRUE(contains(faultOf(result, preset), "1 sphere ended at positions that are not "
                                                      "finite"));
    }
}

TEST(Verdict, BlamesMoreThanHalfAPerCentThatHang)
{
    FillResult result = goodResult();
    result.quality.unsupported = 6;
    EXPECT_TRUE(
        contains(faultOf(result), "6 spheres of 1000 are at rest without support, where 5 may be"));
    result.spheres = 10;
    result.quality.unsupported = 1;
    EXPECT_EQ(faultOf(result), "");
    result.quality.unsupported = 2;
    EXPECT_TRUE(contains(faultOf(result), "2 spheres of 10"));
}

TEST(Verdict, AllowsOverlapsAndHangingSpheresOfThePaper)
{
    FillResult result = goodResult();
    result.quality.maxOverlap = 0.5;
    result.quality.maxWallOverlap = 0.5;
    result.quality.unsupported = 1000;
    EXPECT_EQ(faultOf(result, Preset::paper), "");
    result.quality.centresOutside = 1;
    EXPECT_TRUE(contains(faultOf(result, Preset::paper), "1 sphere ended outside"));
}

TEST(Verdict, DoesNotJudgeTheSupportOfARunThatWasStopped)
{
    FillResult result = goodResult();
    result.quality.unsupported = 1000;
    result.stopped = true;
    EXPECT_EQ(faultOf(result), "");
    result.quality.notFinite = 2;
    EXPECT_TRUE(contains(faultOf(result), "2 spheres ended at positions that are not finite"));
}

TEST(Verdict, DoesNotJudgeSupportWhereOnlyTheTimeLimitEndsBouncing)
{
    FillResult result = goodResult();
    result.quality.unsupported = 1000;
    Scene scene = presetScene(Preset::fast, "cube");
    scene.motion.restitution = 1;
    EXPECT_FALSE(findFault(scene, result, false));
}

TEST(Verdict, NamesTheSphereForWhichTheRunWasStopped)
{
    FillResult result = goodResult();
    result.stray = StraySphere{StrayKind::outside, 17, {1, 2, 3}, 0.25};
    const std::string outside = faultOf(result);
    EXPECT_TRUE(contains(outside, "sphere 17 was outside the object, at (1 2 3) after 0.25 s"))
        << outside;
    result.stray->kind = StrayKind::tooFast;
    EXPECT_TRUE(contains(faultOf(result), "10 times as fast as a fall"));
    result.stray->kind = StrayKind::notFinite;
    EXPECT_TRUE(contains(faultOf(result), "not finite"));
}

TEST(Verdict, BlamesBlankPicturesLast)
{
    const Scene scene = presetScene(Preset::fast, "cube");
    EXPECT_TRUE(contains(findFault(scene, goodResult(), true).value_or(""), "blank"));
}

TEST(FailureOf, ARunIsItsPostconditionBeforeItsVideoAndNamesTheFolder)
{
    FillResult result = goodResult();
    result.directory = "out";
    EXPECT_FALSE(failureOf(result));
    result.videoFailure = "no ffmpeg";
    ASSERT_TRUE(failureOf(result));
    EXPECT_EQ(failureOf(result)->code(), ErrorCode::writeFailed);
    EXPECT_STREQ(failureOf(result)->what(), "no ffmpeg; the frames are in out");
    result.failure = "two spheres overlap";
    EXPECT_EQ(failureOf(result)->code(), ErrorCode::postcondition);
    EXPECT_STREQ(failureOf(result)->what(), "two spheres overlap; the files are in out");
}

TEST(FailureOf, PicturesIsThatTheyAreBlankBeforeTheirVideo)
{
    RenderResult result;
    result.directory = "out";
    EXPECT_FALSE(failureOf(result));
    result.videoFailure = "no ffmpeg";
    EXPECT_EQ(failureOf(result)->code(), ErrorCode::writeFailed);
    result.blank = true;
    EXPECT_EQ(failureOf(result)->code(), ErrorCode::postcondition);
}

} // namespace
} // namespace frostfill
