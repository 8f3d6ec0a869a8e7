// SPDX-License-Identifier: MIT
#include "scene/radius_distribution.hpp"

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/options.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace frostfill
{
namespace
{

using test::expectError;
using test::TemporaryFolder;

std::string fileWith(const TemporaryFolder& folder, const std::string& text)
{
    const std::string file = (folder.path() / "radii.txt").string();
    std::ofstream(file) << text;
    return file;
}

TEST(RadiusDistribution, GivesOneRadiusWithoutRounding)
{
    const RadiusDistribution radii = RadiusDistribution(Radii(0.1)).inLargest();
    EXPECT_TRUE(radii.equal());
    EXPECT_EQ(radii.draw(0.7, 1), 1);
    EXPECT_EQ(radii.meanPower(3), 1);
}

TEST(RadiusDistribution, IsEvenBetweenTwoRadiiUpToALimit)
{
    const RadiusDistribution radii(Radii(0.2, 1));
    EXPECT_DOUBLE_EQ(radii.draw(0, 1), 0.2);
    EXPECT_DOUBLE_EQ(radii.draw(0.5, 1), 0.6);
    EXPECT_DOUBLE_EQ(radii.draw(0.5, 0.4), 0.3);
    EXPECT_DOUBLE_EQ(radii.draw(0.5, 0.1), 0.2);
    for (int power = 1; power <= 3; ++power)
    {
        double sum = 0; // midpoint rule
        for (int k = 0; k < 1000; ++k)
        {
            sum += std::pow(radii.draw((k + 0.5) / 1000, 1), power) / 1000;
        }
        EXPECT_NEAR(radii.meanPower(power), sum, 1e-6);
    }
}

// Rounding may take the inverse of a share beyond where the share was taken.
TEST(RadiusDistribution, NeverGivesARadiusOfACurveBeyondTheLimit)
{
    for (const SharesOf by : {SharesOf::mass, SharesOf::number})
    {
        for (int k = 0; k < 200; ++k)
        {
            const std::string curve = "normal:" + std::to_string(0.04 + 1e-5 * k) + ",0.008";
            const RadiusDistribution radii =
                RadiusDistribution({.curve = curve, .by = by}).inLargest();
            for (const double limit : {radii.smallest(), 0.1, 0.5, 0.75, 1.0})
            {
                for (const double uniform : {0.0, 0.3, 1 - 1e-16})
                {
                    const double radius = radii.draw(uniform, limit);
                    EXPECT_GE(radius, radii.smallest());
                    EXPECT_LE(radius, std::max(limit, radii.smallest())) << curve;
                }
            }
        }
    }
}

TEST(RadiusDistribution, DrawsTheLinesOfAFileWithEqualLikelihood)
{
    const TemporaryFolder folder;
    const RadiusDistribution radii(
        Radii::fromFile(fileWith(folder, "# two sizes\n0.5\n\n 0.25 # fine\r\n0.25\n0.25\n")));
    EXPECT_EQ(radii.smallest(), 0.25);
    EXPECT_EQ(radii.largest(), 0.5);
    EXPECT_EQ(radii.draw(0.74, 1), 0.25);
    EXPECT_EQ(radii.draw(0.76, 1), 0.5);
    EXPECT_EQ(radii.draw(0.99, 0.4), 0.25);
    EXPECT_EQ(radii.distinct(2), (std::vector<double>{0.25, 0.5}));
    EXPECT_TRUE(radii.distinct(1).empty());
    EXPECT_DOUBLE_EQ(radii.meanPower(1), 1.25 / 4);
    EXPECT_EQ(radii.inLargest().smallest(), 0.5);
}

TEST(RadiusDistribution, RefusesAFileWithTheLineThatIsWrong)
{
    const TemporaryFolder folder;
    const auto read = [](const std::string& file)
    { (void)RadiusDistribution(Radii::fromFile(file)); };
    expectError(
        ErrorCode::badData, [&] { read(fileWith(folder, "0.1\n-2\n")); }, "line 2", "'-2'");
    expectError(
        ErrorCode::badData, [&] { read(fileWith(folder, "0.1 0.2\n")); }, "line 1", "'0.1 0.2'");
    expectError(
        ErrorCode::badData, [&] { read(fileWith(folder, "# none\n")); }, "no radii", "radii.txt");
    expectError(
        ErrorCode::inputMissing, [&] { read("not/there.txt"); }, "not/there.txt", "does not exist");
}

TEST(RadiusDistribution, IsWrittenAsANumberARangeOrAFile)
{
    const Option& option = *findOption("spheres.radius");
    Scene scene;
    const auto set = [&](const char* text)
    {
        const auto value = readOptionText(option, text);
        return value && setOption(option, scene, *value);
    };
    ASSERT_TRUE(set("0.25"));
    EXPECT_EQ(scene.spheres.radius, Radii(0.25));
    ASSERT_TRUE(set("0.02..0.05"));
    EXPECT_EQ(scene.spheres.radius, Radii(0.02, 0.05));
    EXPECT_EQ(option.get(scene), OptionValue("0.02..0.05"));
    EXPECT_EQ(parseScene(sceneToToml(scene), "test").spheres.radius, scene.spheres.radius);
    ASSERT_TRUE(set("my/radii.txt"));
    EXPECT_EQ(scene.spheres.radius, Radii::fromFile("my/radii.txt"));
    for (const char* wrong : {"0.05..0.02", "0..1", "1..", "1..inf", "1..2x", "some", ""})
    {
        EXPECT_FALSE(set(wrong)) << wrong;
    }
}

} // namespace
} // namespace frostfill
