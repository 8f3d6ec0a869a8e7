// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/output.hpp>

#include <sys/resource.h>

#include <csignal>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::expectError;
using test::readFile;
using test::TemporaryFolder;

TEST(SpheresCsv, HasARowASphereWithAsManyDigitsAsBringItBack)
{
    const TemporaryFolder folder;
    const std::vector<SphereRecord> spheres = {
        {{0.1, -2, 1e-7}, 0.25, 0, SphereState::discarded},
        {{1.0 / 3.0, 0, 5}, 0.25, 3, SphereState::frozen},
        {{1, 2, 3}, 0.25, 4, SphereState::running},
    };
    writeSpheresCsv(spheres, folder / "spheres.csv");
    EXPECT_EQ(readFile(folder / "spheres.csv"), "id,group,x,y,z,radius,state\n"
                                                "0,0,0.1,-2,1e-07,0.25,discarded\n"
                                                "1,3,0.3333333333333333,0,5,0.25,frozen\n"
                                                "2,4,1,2,3,0.25,running\n");
}

TEST(SpheresCsv, IsTheSameWithAnyNumberOfThreads)
{
    const TemporaryFolder folder;
    // More than are made into text at once, the last part of them not full.
    constexpr std::size_t kCount = 2 * 16 * 1024 + 1500;
    std::string expected = "id,group,x,y,z,radius,state\n";
    for (std::size_t id = 0; id < kCount; ++id)
    {
        expected += std::to_string(id) + "," + std::to_string(id / 7) + "," + std::to_string(id) +
                    ",0.5,-3,0.25,frozen\n";
    }
    for (const int threads : {1, 2, 3, 8, 16})
    {
        std::size_t asked = 0;
        writeSpheresCsv(
            kCount,
            [&](std::size_t id)
            {
                EXPECT_EQ(id, asked++); // as rows that are read back from a file need it
                return SphereRecord{{static_cast<double>(id), 0.5, -3},
                                    0.25,
                                    static_cast<std::uint32_t>(id / 7),
                                    SphereState::frozen};
            },
            folder / "spheres.csv", {}, threads);
        EXPECT_EQ(readFile(folder / "spheres.csv"), expected) << threads;
    }
}

TEST(PolygonsCsv, HasARowAPolygon)
{
    const TemporaryFolder folder;
    writePolygonsCsv(std::vector{PolygonState::active, PolygonState::discarded},
                     folder / "polygons.csv");
    EXPECT_EQ(readFile(folder / "polygons.csv"), "id,state\n0,active\n1,discarded\n");
}

TEST(AtomicFile, AppearsOnlyWhenItIsComplete)
{
    const TemporaryFolder folder;
    {
        AtomicFile file(folder / "a");
        file.write("half");
        EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));

    test::writeFile(folder / "a", "old");
    AtomicFile file(folder / "a");
    file.write("new");
    EXPECT_EQ(readFile(folder / "a"), "old");
    file.commit();
    EXPECT_EQ(readFile(folder / "a"), "new");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.part"));
}

TEST(AtomicFile, TellsThatItCannotBeCreated)
{
    expectError(
        ErrorCode::cannotCreate, [] { AtomicFile file("no/such/folder/a"); }, "no/such/folder/a");
}

/// While it lives, no file of this process may grow beyond some bytes.
class FullDisk
{
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
    {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit now = before_;
        now.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &now);
    }
    ~FullDisk()
    {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    void (*handler_)(int);
    rlimit before_ = {};
};

TEST(AtomicFile, TellsThatTheDiskIsFull)
{
    const TemporaryFolder folder;
    const auto write = [&]
    {
        const FullDisk disk(10);
        AtomicFile file(folder / "a");
        file.write(std::string(100, 'x'));
        file.commit();
    };
    expectError(ErrorCode::writeFailed, write, "cannot write", "File too large");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(AtomicFile, WritesThroughNoSymbolicLink)
{
    const TemporaryFolder folder;
    test::writeFile(folder / "mine", "mine");
    std::filesystem::create_symlink(folder / "mine", folder / "a.part");
    AtomicFile file(folder / "a");
    file.write("new");
    file.commit();
    EXPECT_EQ(test::readFile(folder / "mine"), "mine");
    EXPECT_EQ(test::readFile(folder / "a"), "new");
    EXPECT_FALSE(std::filesystem::is_symlink(folder / "a"));
}

TEST(CreateDirectory, TellsThatAFileIsInTheWay)
{
    const TemporaryFolder folder;
    test::writeFile(folder / "file", "");
    expectError(
        ErrorCode::cannotCreate, [&] { createDirectory(folder / "file"); }, "file");
    expectError(
        ErrorCode::cannotCreate, [&] { createDirectory((folder / "file") / "inner"); }, "file");
}

} // namespace
} // namespace frostfill
