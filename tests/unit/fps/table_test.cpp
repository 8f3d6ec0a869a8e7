// SPDX-License-Identifier: MIT
#include "fps/table.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

Table sample()
{
    return {"Title", {"object", "ms"}, {{"torus", "1.5"}, {"cube", "10 ± 2"}}, 1};
}

TEST(Table, AlignsWordsLeftAndNumbersRightWhateverTheirBytes)
{
    EXPECT_EQ(formatText(sample()), "Title\n"
                                    "object      ms\n"
                                    "torus      1.5\n"
                                    "cube    10 ± 2\n");
}

TEST(Table, IsMarkdown)
{
    EXPECT_EQ(formatMarkdown(sample()), "**Title**\n\n"
                                        "| object | ms |\n"
                                        "|---|---:|\n"
                                        "| torus | 1.5 |\n"
                                        "| cube | 10 ± 2 |\n");
}

TEST(Table, QuotesWhatCsvHasToQuote)
{
    Table table = sample();
    table.rows = {{"a,b", "say \"x\""}};
    EXPECT_EQ(formatCsv(table), "object,ms\n\"a,b\",\"say \"\"x\"\"\"\n");
}

} // namespace
} // namespace frostfill
