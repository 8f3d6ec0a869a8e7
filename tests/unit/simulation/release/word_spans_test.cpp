// SPDX-License-Identifier: MIT
#include "simulation/release/word_spans.hpp"

#include "base/random.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

/// Some words of 12 rows of 200, in order: gaps, rows without any, spans longer than a stride.
std::vector<WordPlace> someWords(std::uint64_t seed)
{
    std::vector<WordPlace> words;
    std::uint64_t draws = 0;
    for (int z = 0; z < 3; ++z)
    {
        for (int y = 0; y < 4; ++y)
        {
            const double chance = uniformRandom(seed, 0, draws++);
            const bool isWhole = (y + z) % 3 == 0;
            for (int x = 0; x < 200 && chance > 0.2; ++x)
            {
                if (isWhole || uniformRandom(seed, 0, draws++) < chance)
                {
                    words.push_back({x, y, z});
                }
            }
        }
    }
    return words;
}

// The list itself is the oracle.
TEST(WordSpans, NumberWordsAsAListOfThemDoes)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
    {
        const std::vector<WordPlace> list = someWords(seed);
        WordSpans spans;
        for (const WordPlace& word : list)
        {
            spans.append(word);
        }
        ASSERT_EQ(spans.size(), list.size());
        for (std::size_t k = 0; k < list.size(); ++k)
        {
            ASSERT_EQ(spans.place(k), list[k]) << k;
        }
        for (int z = -1; z < 4; ++z)
        {
            for (int y = -1; y < 5; ++y)
            {
                for (int x = 0; x < 202; ++x)
                {
                    const WordPlace word = {x, y, z};
                    const auto from =
                        std::lower_bound(list.begin(), list.end(), word, WordSpans::isBefore);
                    const auto number = static_cast<std::size_t>(from - list.begin());
                    ASSERT_EQ(spans.firstFrom(word), number) << x << " " << y << " " << z;
                    const bool isThere = from != list.end() && *from == word;
                    ASSERT_EQ(spans.find(word), isThere ? number : WordSpans::kNone);
                }
            }
        }
    }
}

TEST(WordSpans, OfNoWordsHaveNone)
{
    const WordSpans none;
    EXPECT_EQ(none.size(), 0u);
    EXPECT_EQ(none.firstFrom({3, 2, 1}), 0u);
    EXPECT_EQ(none.find({3, 2, 1}), WordSpans::kNone);
}

} // namespace
} // namespace frostfill
