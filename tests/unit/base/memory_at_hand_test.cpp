// SPDX-License-Identifier: MIT
#include "base/resources.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace frostfill
{
namespace
{

constexpr std::size_t kGigabyte = std::size_t{1} << 30;

TEST(MemoryAtHand, IsMoreThanWhatThisTestTakesAndLessThanAnyMachineHas)
{
    EXPECT_GT(memoryAtHand().bytes, 1e8);
    EXPECT_LT(memoryAtHand().bytes, 1e15);
}

/// A root folder whose process is in the groups that a text names.
class ControlGroups : public ::testing::Test
{
protected:
    void groups(const std::string& text) { write("proc/self/cgroup", text); }
    void write(const std::string& file, const std::string& text)
    {
        std::filesystem::create_directories((folder_ / file).parent_path());
        test::writeFile(folder_ / file, text);
    }
    [[nodiscard]] MemoryAtHand atHand() const { return memoryAtHand(folder_.path()); }
    /// What is left once a file of the control groups has this text. [bytes]
    double leftWith(const std::string& file, const std::string& text)
    {
        write("sys/fs/cgroup/" + file, text);
        return atHand().bytes;
    }
    test::TemporaryFolder folder_;
};

TEST_F(ControlGroups, BoundMemoryByTheLimitLessTheCurrentUse)
{
    groups("0::/job/step\n");
    EXPECT_EQ(leftWith("job/step/memory.max", "64000000\n"), 64e6);
    EXPECT_EQ(leftWith("job/step/memory.current", "24000000\n"), 40e6);
    EXPECT_NE(atHand().bound.find("sys/fs/cgroup/job/step is 0.064 GB"), std::string::npos)
        << atHand().bound;
    EXPECT_EQ(leftWith("job/step/memory.high", "50000000\n"), 26e6);
    EXPECT_NE(atHand().bound.find("memory.high"), std::string::npos) << atHand().bound;
}

TEST_F(ControlGroups, BoundMemoryByTheirParentsToo)
{
    groups("0::/job/step\n");
    write("sys/fs/cgroup/job/step/memory.max", "max\n");
    EXPECT_EQ(leftWith("job/memory.max", "32000000\n"), 32e6);
    EXPECT_EQ(leftWith("memory.max", "16000000\n"), 16e6);
}

TEST_F(ControlGroups, OfVersionOneBoundMemoryEvenWhereAContainerSeesOnlyItsOwn)
{
    groups("5:cpu:/other\n4:memory:/container/of/the/host\n0::/\n");
    EXPECT_EQ(leftWith("memory/memory.limit_in_bytes", "48000000\n"), 48e6);
    EXPECT_EQ(leftWith("memory/memory.usage_in_bytes", "8000000\n"), 40e6);
    EXPECT_EQ(leftWith("memory/container/of/the/host/memory.limit_in_bytes", "4000000\n"), 4e6);
}

TEST_F(ControlGroups, CountFilesInTheCacheAsFree)
{
    groups("0::/job\n");
    write("sys/fs/cgroup/job/memory.max", "64000000\n");
    EXPECT_EQ(leftWith("job/memory.current", "60000000\n"), 4e6);
    EXPECT_EQ(leftWith("job/memory.stat", "anon 4000000\ninactive_file 50000000\n"), 54e6);
    EXPECT_EQ(leftWith("job/memory.current", "80000000\n"), 34e6);
}

TEST_F(ControlGroups, WithoutALimitLeaveWhatTheMachineHas)
{
    groups("4:memory:/a\n0::/\n");
    EXPECT_GT(leftWith("memory/a/memory.limit_in_bytes", "9223372036854771712\n"), 1e8);
    EXPECT_EQ(atHand().bound.find("control group"), std::string::npos);
}

TEST(MemoryAtHand, MayBeMappedAndNoMoreThanThereCanBe)
{
    EXPECT_TRUE(mayMap(1 << 20));
    EXPECT_FALSE(mayMap(SIZE_MAX / 2));
}

TEST(MemoryAtHandDeathTest, MayNotBeMappedBeyondALimitOnTheAddressSpace)
{
#ifdef FROSTFILL_SANITIZED
    GTEST_SKIP() << "a sanitizer maps more than any limit";
#endif
    EXPECT_EXIT(
        {
            const bool before = mayMap(4 * kGigabyte);
            rlimit limit;
            limit.rlim_cur = limit.rlim_max = 2 * kGigabyte;
            const bool set = setrlimit(RLIMIT_AS, &limit) == 0;
            std::exit(before && set && mayMap(1 << 20) && !mayMap(4 * kGigabyte) ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace frostfill
