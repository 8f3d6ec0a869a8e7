// SPDX-License-Identifier: MIT
// Files that are refused are in the table of wrong calls, tests/support/wrong_calls.txt.
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

} // namespace
} // namespace frostfill
