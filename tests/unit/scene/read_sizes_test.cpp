// SPDX-License-Identifier: MIT
#include "scene/read_sizes.hpp"

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/scene.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::expectError;
using test::TemporaryFolder;

class SizeFiles : public ::testing::Test
{
protected:
    SizeSettings with(const std::string& text, std::optional<SharesOf> by = std::nullopt) const
    {
        std::ofstream(file) << text;
        return {.curve = file, .by = by};
    }

    TemporaryFolder folder;
    std::string file = (folder.path() / "sieve.csv").string();
};

TEST_F(SizeFiles, ReadSharesOfRadiiInPerCentOrNot)
{
    for (const char* shares : {"1,20\n4,30\n16,50\n", "1,0.2\n4,0.3\n16,0.5\n"})
    {
        const SizeCurve curve = readSizeCurve(with(std::string("radius,mass share\n") + shares));
        EXPECT_EQ(curve.distinct(), (std::vector<double>{1, 4, 16}));
        EXPECT_NEAR(curve.cumulative(4, SizeCurve::kMass), 0.5, 1e-15);
        EXPECT_EQ(curve.sieves(), (std::vector<double>{1, 4, 16}));
    }
}

TEST_F(SizeFiles, HalveDiametersAndTakeCumulativeCurvesFromEitherEnd)
{
    const std::string up = "Diameter;Cumulative volume %\n2;0\n8;40\n20;100\n";
    const std::string down = "\xEF\xBB\xBF# sieves\ndiameter , passing by mass\r\n\r\n"
                             "20 , 100 # the coarsest\r\n8,40\r\n2,0\r\n";
    for (const std::string& text : {up, down})
    {
        const SizeCurve curve = readSizeCurve(with(text));
        EXPECT_EQ(curve.smallest(), 1);
        EXPECT_EQ(curve.largest(), 10);
        EXPECT_NEAR(curve.cumulative(4, SizeCurve::kMass), 0.4, 1e-15);
        EXPECT_NEAR(curve.cumulative(7, SizeCurve::kMass), 0.7, 1e-15);
        EXPECT_GE(curve.sieves().size(), 20U);
    }
}

TEST_F(SizeFiles, TakeACurveThatRisesAtOneSizeForSpheresOfThatSize)
{
    const SizeCurve curve =
        readSizeCurve(with("radius,cumulative\n1,0\n1,0.5\n2,0.5\n2,1\n", SharesOf::number));
    EXPECT_EQ(curve.distinct(), (std::vector<double>{1, 2}));
    EXPECT_EQ(curve.meanPower(1), 1.5);
}

TEST_F(SizeFiles, TakeVolumeForMassButNotForNumber)
{
    const std::string text = "radius,volume share\n1,1\n";
    EXPECT_EQ(readSizeCurve(with(text, SharesOf::mass)).largest(), 1);
    expectError(
        ErrorCode::badData, [&] { (void)readSizeCurve(with(text, SharesOf::number)); }, "line 1",
        "--by");
}

struct WrongFile
{
    const char* text;
    const char* where;
    const char* what;
};

class WrongSizeFiles : public SizeFiles, public ::testing::WithParamInterface<WrongFile>
{
};

TEST_P(WrongSizeFiles, AreRefusedInASentenceWithFileAndLine)
{
    const auto& [text, where, what] = GetParam();
    expectError(
        ErrorCode::badData, [&] { (void)readSizeCurve(with(text)); }, "sieve.csv", where, what);
}

INSTANTIATE_TEST_SUITE_P(
    Files, WrongSizeFiles,
    ::testing::Values(
        WrongFile{"", "empty", "header"}, WrongFile{"# nothing\n\n", "empty", "header"},
        WrongFile{"1,20\n2,80\n", "line 1", "'1' is not radius or diameter"},
        WrongFile{"size,mass share\n1,1\n", "line 1", "'size' is not radius"},
        WrongFile{"diameter [mm],mass share\n1,1\n", "line 1", "'[mm]'"},
        WrongFile{"radius\n1\n", "line 1", "does not name two columns"},
        WrongFile{"radius,mass share,more\n1,1,1\n", "line 1", "does not name two columns"},
        WrongFile{"radius,weight\n1,1\n", "line 1", "'weight' is not share"},
        WrongFile{"radius,mass\n1,1\n", "line 1", "column 2 must be share"},
        WrongFile{",mass share\n1,1\n", "line 1", "column 1 must be radius or diameter"},
        WrongFile{"radius,share\n1,1\n", "line 1", "--by"},
        WrongFile{"radius,mass share\n", "line 1", "no row"},
        WrongFile{"radius,mass share\n1\n", "line 2", "two numbers"},
        WrongFile{"radius,mass share\n1,2,3\n", "line 2", "two numbers"},
        WrongFile{"radius;mass share\n1,5;1\n", "line 2", "'1,5' must be a radius"},
        WrongFile{"radius,mass share\none,1\n", "line 2", "'one' must be a radius"},
        WrongFile{"radius,mass share\n1,all\n", "line 2", "'all' must be a share"},
        WrongFile{"radius,mass share\nnan,1\n", "line 2", "'nan' must be a radius"},
        WrongFile{"radius,mass share\n1,inf\n", "line 2", "'inf' must be a share"},
        WrongFile{"radius,mass share\n0,1\n", "line 2", "the radius is 0"},
        WrongFile{"diameter,mass share\n1,0.5\n-2,0.5\n", "line 3", "the diameter is -2"},
        WrongFile{"radius,mass share\n1e13,1\n", "line 2", "the radius is 1e+13"},
        WrongFile{"radius,mass share\n1,-0.5\n2,1.5\n", "line 2", "the share is -0.5"},
        WrongFile{"radius,mass share\n1,120\n", "line 2", "the share is 120"},
        WrongFile{"radius,mass share\n1,0.5\n2,0.4\n", "line 3", "add up to 0.9"},
        WrongFile{"radius,mass share\n1,60\n2,41\n", "line 3", "add up to 101"},
        WrongFile{"radius,mass share\n1,0\n", "line 2", "add up to 0"},
        WrongFile{"radius,mass share\n1,50\n1,50\n", "line 3", "in line 2"},
        WrongFile{"radius,mass share\n1,20\n3,30\n2,50\n", "line 4", "ascend"},
        WrongFile{"radius,cumulative mass\n1,0\n2,60\n3,50\n4,100\n", "line 4", "the curve falls"},
        WrongFile{"radius,cumulative mass\n4,100\n3,50\n2,60\n1,0\n", "line 3", "the curve falls"},
        WrongFile{"radius,cumulative mass\n1,10\n2,100\n", "line 2", "begins with 10"},
        WrongFile{"radius,cumulative mass\n1,0\n2,90\n", "line 3", "ends with 90"},
        WrongFile{"radius,mass share\n1,0.5\n101,0.5\n", "line 3", "101 times"}));

class WrongNames : public ::testing::TestWithParam<std::pair<const char*, const char*>>
{
};

TEST_P(WrongNames, AreRefusedInASentenceWithWhatIsWrong)
{
    const auto& [text, what] = GetParam();
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.sizes = {.curve = text, .by = SharesOf::mass};
    expectError(
        ErrorCode::usage, [&] { validateScene(scene); }, "--sizes", text, what);
}

INSTANTIATE_TEST_SUITE_P(
    Names, WrongNames,
    ::testing::Values(
        std::pair("gauss:1,2", "no distribution 'gauss'"),
        std::pair("lognormal:", "'' must be a number"),
        std::pair("lognormal:1", "'' must be a number"),
        std::pair("lognormal:1,0", "'0' must be a number above 0"),
        std::pair("lognormal:-1,2", "'-1' must be"), std::pair("lognormal:nan,2", "'nan' must be"),
        std::pair("lognormal:1,2,3", "'' must be"),
        std::pair("lognormal:1,0.2,2..1", "the smaller one first"),
        std::pair("lognormal:1,0.2,1..1", "the smaller one first"),
        std::pair("lognormal:1,0.01,5..6", "next to nothing"), std::pair("lognormal:1,5", "factor"),
        std::pair("normal:1,1", "below 0"), std::pair("normal:1,0.5,0..2", "'0' must be"),
        std::pair("weibull:1,0.5", "factor"), std::pair("weibull:1,2,0.1..x", "'x' must be")));

TEST(WrongSizes, AreRefusedWhenTheSceneContradictsItself)
{
    const auto refused = [](const char* what, const auto& change)
    {
        Scene scene = presetScene(Preset::fast, "cube");
        scene.spheres.sizes = {.curve = "lognormal:0.1,0.02", .by = SharesOf::mass};
        change(scene);
        expectError(
            ErrorCode::usage, [&] { validateScene(scene); }, what);
    };
    refused("not both", [](Scene& scene) { scene.spheres.radius = 0.1; });
    refused("--by", [](Scene& scene) { scene.spheres.sizes.by.reset(); });
    refused("--curve-within", [](Scene& scene) { scene.spheres.sizes.within = 1.5; });
    refused("--sizes", [](Scene& scene) { scene.spheres.sizes.curve.reset(); });
    refused("--inlet",
            [](Scene& scene)
            {
                scene.spheres.sizes.fillGaps = true;
                scene.spheres.inlets = {{{0, 0.5, 0}, 0.3}};
            });
    refused("--tilt",
            [](Scene& scene)
            {
                scene.spheres.sizes.fillGaps = true;
                scene.move.tilt = 5;
            });
    refused("paper",
            [](Scene& scene)
            {
                scene.preset = Preset::paper;
                scene.discard.rule = DiscardRule::paper;
                scene.spheres.groupSize = 10;
            });
    expectError(
        ErrorCode::inputMissing,
        [] { (void)readSizeCurve({.curve = "no/such.csv", .by = SharesOf::mass}); }, "no/such.csv");
}

} // namespace
} // namespace frostfill
