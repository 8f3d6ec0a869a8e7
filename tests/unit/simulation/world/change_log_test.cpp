// SPDX-License-Identifier: MIT
#include "simulation/world/spheres.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace frostfill
{
namespace
{

std::vector<std::uint32_t> since(const ChangeLog& log, std::size_t& seen, std::size_t spheres)
{
    std::vector<std::uint32_t> ids;
    log.forEachSince(seen, spheres, [&](std::uint32_t id) { ids.push_back(id); });
    return ids;
}

TEST(ChangeLog, TellsWhoFollowsItEachChangeOnceAndInOrder)
{
    ChangeLog log;
    std::size_t seen = 0;
    constexpr std::uint32_t kSpheres = 100;
    for (std::uint32_t k = 0; k < 50000; ++k)
    {
        log.add(7 * k % kSpheres, kSpheres);
        if (k % 1000 == 999)
        {
            const std::vector<std::uint32_t> ids = since(log, seen, kSpheres);
            ASSERT_EQ(ids.size(), 1000u);
            for (std::uint32_t i = 0; i < 1000; ++i)
            {
                ASSERT_EQ(ids[i], 7 * (k - 999 + i) % kSpheres);
            }
        }
    }
    EXPECT_EQ(log.count(), 50000u);
    EXPECT_TRUE(since(log, seen, kSpheres).empty());
}

TEST(ChangeLog, TellsWhoHasFallenBehindOfEverySphereAndFollowsOn)
{
    constexpr std::uint32_t kSpheres = 200000;
    ChangeLog log;
    std::size_t seen = 0;
    for (std::uint32_t id = 0; id < kSpheres; ++id)
    {
        log.add(id, kSpheres);
    }
    log.add(3, kSpheres);
    const std::vector<std::uint32_t> ids = since(log, seen, kSpheres);
    EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), kSpheres);
    EXPECT_EQ(seen, log.count());
    log.add(5, kSpheres);
    EXPECT_EQ(since(log, seen, kSpheres), std::vector<std::uint32_t>{5});
}

TEST(ChangeLog, RemembersAnEighthOfTheSpheresWhateverCame)
{
    constexpr std::uint32_t kSpheres = 80000;
    ChangeLog log;
    for (std::uint32_t k = 0; k < 3 * kSpheres; ++k)
    {
        log.add(k % kSpheres, kSpheres);
        if (k >= kSpheres / 8 && k % 977 == 0)
        {
            std::size_t seen = log.count() - kSpheres / 8;
            ASSERT_EQ(since(log, seen, kSpheres).size(), kSpheres / 8);
        }
    }
    std::size_t seen = log.count() - kSpheres / 4 - 1;
    EXPECT_EQ(since(log, seen, kSpheres).size(), kSpheres); // no more than twice that
}

} // namespace
} // namespace frostfill
