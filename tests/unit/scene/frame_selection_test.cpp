// SPDX-License-Identifier: MIT
#include "scene/frame_selection.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

std::vector<std::size_t> chosen(const char* text, std::size_t frames)
{
    const FrameSelection selection = FrameSelection::parse(text).value();
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < frames; ++i)
    {
        if (selection.has(i))
        {
            numbers.push_back(i);
        }
    }
    return numbers;
}

using Numbers = std::vector<std::size_t>;

TEST(FrameSelection, TakesNumbersAndRangesWithoutTheirEnds)
{
    EXPECT_EQ(chosen("7", 20), (Numbers{7}));
    EXPECT_EQ(chosen("0:30:10", 100), (Numbers{0, 10, 20}));
    EXPECT_EQ(chosen("3:6", 100), (Numbers{3, 4, 5}));
    EXPECT_EQ(chosen("8:", 11), (Numbers{8, 9, 10}));
    EXPECT_EQ(chosen("5,3:5,90:100:9,last", 95), (Numbers{3, 4, 5, 90}));
    EXPECT_EQ(chosen("all", 3), (Numbers{0, 1, 2}));
    EXPECT_EQ(chosen("0..30:10", 100), (Numbers{0, 10, 20, 30})) << "as radii have them";
    EXPECT_EQ(chosen("3..6,9..9", 100), (Numbers{3, 4, 5, 6, 9}));
    EXPECT_EQ(chosen("8..", 11), (Numbers{8, 9, 10}));
    EXPECT_EQ(chosen("last", 100), Numbers());
    EXPECT_EQ(chosen("none", 100), Numbers());
}

TEST(FrameSelection, KnowsWhetherTheLastStateIsWanted)
{
    EXPECT_TRUE(FrameSelection::parse("all")->hasLast());
    EXPECT_TRUE(FrameSelection::parse("1,last")->hasLast());
    EXPECT_FALSE(FrameSelection::parse("0:100")->hasLast());
    EXPECT_FALSE(FrameSelection::parse("none")->hasLast());
}

TEST(FrameSelection, RefusesWhatIsNotOfItsForm)
{
    for (const char* text :
         {"",    ",",    "1,",   ",1",   "x",      "1:2:3:4", "1:2:0", "-1",
          "1.5", ":",    "1::2", "1:2:", "none,1", "all,1",   " 1",    "5:5",
          "9:3", "9..3", "..",   "..3",  "1..2:0", "1..2:",   "1...3", "18446744073709551615"})
    {
        EXPECT_FALSE(FrameSelection::parse(text).has_value()) << "'" << text << "'";
    }
}

TEST(FrameSelection, CountsFramesForTheEstimate)
{
    EXPECT_EQ(FrameSelection::parse("all")->countOf(12), 12u);
    EXPECT_EQ(FrameSelection::parse("0:100:10")->countOf(35), 4u);
    EXPECT_EQ(FrameSelection::parse("50:100")->countOf(35), 0u);
    EXPECT_EQ(FrameSelection::parse("last")->countOf(35), 1u);
    EXPECT_EQ(FrameSelection::parse("5,7,last")->countOf(35), 3u);
    EXPECT_EQ(FrameSelection::parse("0..9,5,9,34,last")->countOf(35), 11u);
}

} // namespace
} // namespace frostfill
