// SPDX-License-Identifier: MIT
#include "base/spilled_array.hpp"

#include "base/sanitized.hpp"
#include "support/memory_in_use.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <vector>

namespace frostfill
{
namespace
{

using test::memoryInUse;

constexpr std::size_t kFew = 1000;
constexpr std::size_t kMany = std::size_t{8} << 20; // of eight bytes

std::uint64_t valueOf(std::size_t i)
{
    return i * 0x9e3779b97f4a7c15u;
}

SpilledArray<std::uint64_t> filled(std::size_t count, std::size_t inMemory = kFew)
{
    SpilledArray<std::uint64_t> array(inMemory);
    for (std::size_t i = 0; i < count; ++i)
    {
        array.pushBack(valueOf(i));
    }
    return array;
}

std::size_t wrong(const SpilledArray<std::uint64_t>& array)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < array.size(); ++i)
    {
        count += array[i] == valueOf(i) ? 0 : 1;
    }
    return count;
}

/// What $TMPDIR says until this is destroyed.
class SpillsInto
{
public:
    explicit SpillsInto(const char* folder)
    {
        if (const char* const before = std::getenv("TMPDIR"))
        {
            before_ = before;
        }
        ::setenv("TMPDIR", folder, 1);
    }
    ~SpillsInto()
    {
        before_.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", before_.c_str(), 1);
    }
    SpillsInto(const SpillsInto&) = delete;
    SpillsInto& operator=(const SpillsInto&) = delete;

private:
    std::string before_;
};

/// How large a file may become, until it is destroyed [bytes].
class FileLimit
{
public:
    explicit FileLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit = {bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
    FileLimit(const FileLimit&) = delete;
    FileLimit& operator=(const FileLimit&) = delete;

private:
    rlimit before_ = {};
};

class SpilledArrayTest : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!spillFolder())
        {
            GTEST_SKIP() << "no folder here lies on a disk";
        }
    }
};

TEST_F(SpilledArrayTest, IsAFileOnlyWhereItIsLarge)
{
    EXPECT_FALSE(filled(kFew).isInFile());
    EXPECT_TRUE(filled(kFew + 1).isInFile());
}

TEST_F(SpilledArrayTest, KeepsEachValueWhileItGrowsAndAfterItHasLeftMemory)
{
    SpilledArray<std::uint64_t> array = filled(kMany);
    EXPECT_EQ(wrong(array), 0u);
    array.leave();
    EXPECT_EQ(wrong(array), 0u);
    array[kFew] = 1;
    array.leave();
    EXPECT_EQ(array[kFew], 1u);
    EXPECT_EQ(wrong(array), 1u);
}

TEST_F(SpilledArrayTest, TakesNoMemoryForWhatHasLeft)
{
#ifdef FROSTFILL_SANITIZED
    GTEST_SKIP() << "a sanitizer takes memory of its own";
#endif
    const std::size_t before = memoryInUse();
    const SpilledArray<std::uint64_t> array = filled(kMany);
    const std::size_t bytes = kMany * sizeof(std::uint64_t);
    EXPECT_GT(memoryInUse(), before + bytes / 2);
    array.leave();
    EXPECT_LT(memoryInUse(), before + bytes / 8);
    EXPECT_EQ(array[kMany / 2], valueOf(kMany / 2));
    EXPECT_LT(memoryInUse(), before + bytes / 8);
}

TEST_F(SpilledArrayTest, FillsWhatItGrowsByAndShrinks)
{
    SpilledArray<std::uint32_t> array(kFew);
    array.resize(10, 7);
    array.resize(5, 8);
    array.resize(10 * kFew, 9);
    EXPECT_TRUE(array.isInFile());
    EXPECT_EQ(array[4], 7u);
    EXPECT_EQ(array[5], 9u);
    EXPECT_EQ(array[10 * kFew - 1], 9u);
    array.popBack();
    EXPECT_EQ(array.size(), 10 * kFew - 1);
    EXPECT_EQ(static_cast<std::size_t>(array.end() - array.begin()), array.size());
}

TEST_F(SpilledArrayTest, TakesOverOneOfItsOwnValuesWhileItMoves)
{
    SpilledArray<std::uint64_t> array(kFew);
    array.pushBack(valueOf(3));
    while (array.size() < 100 * kFew)
    {
        array.pushBack(array[0]);
        ASSERT_EQ(array[array.size() - 1], valueOf(3));
    }
}

TEST_F(SpilledArrayTest, GoesWithItsBytesWhenItIsMoved)
{
    SpilledArray<std::uint64_t> first = filled(10 * kFew);
    SpilledArray<std::uint64_t> second = std::move(first);
    first = filled(20 * kFew);
    EXPECT_EQ(second.size(), 10 * kFew);
    EXPECT_EQ(wrong(second), 0u);
    second = std::move(first);
    EXPECT_EQ(second.size(), 20 * kFew);
    EXPECT_EQ(wrong(second), 0u);
}

TEST_F(SpilledArrayTest, IsReadByThreadsWhileItLeaves)
{
    const SpilledArray<std::uint64_t> array = filled(kMany / 16);
    std::atomic<bool> over = false;
    std::atomic<std::size_t> faults = 0;
    std::vector<std::thread> readers;
    for (int k = 0; k < 3; ++k)
    {
        readers.emplace_back([&] { faults += wrong(array) + wrong(array); });
    }
    std::thread leaver(
        [&]
        {
            while (!over)
            {
                array.leave();
            }
        });
    for (std::thread& reader : readers)
    {
        reader.join();
    }
    over = true;
    leaver.join();
    EXPECT_EQ(faults, 0u);
}

TEST_F(SpilledArrayTest, LeavesNoFileBehindInItsFolder)
{
    std::string folder = (*spillFolder() / "frostfill-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(folder.data()), nullptr);
    {
        const SpillsInto temporary(folder.c_str());
        const SpilledArray<std::uint64_t> array = filled(10 * kFew);
        EXPECT_TRUE(array.isInFile());
        EXPECT_TRUE(std::filesystem::is_empty(folder));
    }
    std::filesystem::remove(folder);
}

// A disk that is full is not at hand in a test; a limit on files is refused in the same call.
TEST_F(SpilledArrayTest, StaysInMemoryWhereNoFileMayGrow)
{
    EXPECT_TRUE(maySpill(1e6));
    const FileLimit limit(0);
    EXPECT_FALSE(maySpill(1e6));
    const SpilledArray<std::uint64_t> array = filled(kMany / 16);
    EXPECT_FALSE(array.isInFile());
    EXPECT_EQ(wrong(array), 0u);
}

TEST_F(SpilledArrayTest, ReturnsToMemoryWhenItsFileCannotGrowFurther)
{
    SpilledArray<std::uint64_t> array = filled(10 * kFew);
    ASSERT_TRUE(array.isInFile());
    array.leave();
    const FileLimit limit(std::size_t{20} << 20);
    while (array.size() < kMany)
    {
        array.pushBack(valueOf(array.size()));
    }
    EXPECT_FALSE(array.isInFile());
    EXPECT_EQ(wrong(array), 0u);
}

TEST_F(SpilledArrayTest, AsksForNoMoreThanTheDiskHas)
{
    EXPECT_FALSE(maySpill(1e18));
}

TEST_F(SpilledArrayTest, GivesBackWhatIsNotInUseOfWhatIsInMemory)
{
    SpilledArray<std::uint64_t> array = filled(kFew);
    array.resize(10, 0);
    array.shrinkToFit();
    EXPECT_EQ(array.size(), 10u);
    EXPECT_EQ(wrong(array), 0u);
    for (std::size_t i = 10; i < 2 * kFew; ++i)
    {
        array.pushBack(valueOf(i));
    }
    EXPECT_TRUE(array.isInFile());
    EXPECT_EQ(wrong(array), 0u);
}

TEST(SpillFolder, IsOneOnADiskIfThatIsAskedFor)
{
    const SpillsInto nowhere("/nonexistent");
    EXPECT_NE(spillFolder(), std::filesystem::path("/nonexistent"));
    const SpillsInto memory("/dev/shm");
    EXPECT_NE(spillFolder(), std::filesystem::path("/dev/shm"));
}

} // namespace
} // namespace frostfill
