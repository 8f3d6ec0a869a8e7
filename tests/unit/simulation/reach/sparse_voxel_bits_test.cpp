// SPDX-License-Identifier: MIT
#include "simulation/reach/sparse_voxel_bits.hpp"

#include "base/sanitized.hpp"
#include "base/threads.hpp"
#include "support/heap_in_use.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

using testing_support::heapInUse;

constexpr std::size_t kWordsOfCube = 64;

TEST(SparseVoxelBits, HasWhatAPlainSetHas)
{
    std::mt19937 random(7);
    VoxelBits plain(1000, 0);
    SparseVoxelBits sparse(plain.size());
    for (int round = 0; round < 3; ++round)
    {
        for (int k = 0; k < 300; ++k)
        {
            const VoxelWord cubes{random() % plain.size(), std::uint64_t{1} << random() % 64};
            const std::uint64_t before = plain[cubes.word];
            EXPECT_EQ(k % 2 == 0 ? sparse.add(cubes) : sparse.addShared(cubes), before);
            plain[cubes.word] |= cubes.bits;
        }
        for (std::size_t word = 0; word < plain.size(); ++word)
        {
            ASSERT_EQ(sparse[word], plain[word]) << word;
        }
        sparse.clear();
        plain.assign(plain.size(), 0);
        EXPECT_EQ(sparse[500], 0u);
    }
}

TEST(SparseVoxelBits, TakeMemoryOnlyWhereTheyAre)
{
#ifdef FROSTFILL_SANITIZED
    GTEST_SKIP() << "the heap is the sanitizer's";
#endif
    constexpr std::size_t kPlain =
        kWordsOfCube * 100000 * sizeof(std::uint64_t); // what a plain set takes
    const std::size_t before = heapInUse();
    SparseVoxelBits bits(kWordsOfCube * 100000);
    const std::size_t none = heapInUse();
    EXPECT_LE(none - before, kPlain / 60);
    for (std::size_t word = 0; word < kWordsOfCube * 100; ++word)
    {
        bits.add({word, 1});
    }
    EXPECT_GE(heapInUse() - none, kPlain / 1000 * 9 / 10);
    EXPECT_LE(heapInUse() - none, kPlain / 1000 * 11 / 10);
    SparseVoxelBits moved = std::move(bits);
    EXPECT_EQ(moved[kWordsOfCube * 99], 1u);
    moved.clear();
    EXPECT_LE(heapInUse(), none + kPlain / 10000); // malloc keeps some
}

TEST(SparseVoxelBits, HaveWhatSeveralThreadsAddToTheSameWords)
{
    Threads threads(4);
    for (int repeat = 0; repeat < 50; ++repeat)
    {
        SparseVoxelBits bits(256);
        std::vector<char> isFirst(kWordsOfCube * 256, 0);
        threads.forEach(isFirst.size(),
                        [&](std::size_t i)
                        {
                            const VoxelWord cube{i % 256, std::uint64_t{1} << i / 256};
                            isFirst[i] = bits.addShared(cube) == 0 ? 1 : 0;
                        });
        for (std::size_t word = 0; word < 256; ++word)
        {
            ASSERT_EQ(bits[word], ~std::uint64_t{0});
            int first = 0;
            for (std::size_t i = word; i < isFirst.size(); i += 256)
            {
                first += isFirst[i];
            }
            ASSERT_EQ(first, 1) << "one of them is told that it was empty";
        }
    }
}

} // namespace
} // namespace frostfill
