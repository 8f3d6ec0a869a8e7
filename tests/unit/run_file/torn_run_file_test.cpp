// SPDX-License-Identifier: MIT
// A run file that is cut off or damaged is read up to its last whole record.
#include "run_file/records.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"
#include "unit/run_file/recorded_run.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

namespace frostfill
{
namespace
{

using test::readFile;
using test::RecordedRun;
using test::writeFile;

class TornRunFile : public ::testing::Test
{
protected:
    TornRunFile()
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.spheres.count = 30;
        run_ = test::recordRun(scene, folder_ / "whole.frost", 1);
        bytes_ = readFile(folder_ / "whole.frost");
    }
    /// Reads what is left of the file; refused only if its head and mesh are not whole.
    void expectAPrefix(const std::string& bytes, const std::string& what)
    {
        SCOPED_TRACE(what);
        writeFile(folder_ / "torn.frost", bytes);
        try
        {
            RunFileReader reader(folder_ / "torn.frost");
            ASSERT_LE(reader.frames().size(), run_.frames.size());
            EXPECT_LE(reader.wholeBytes(), reader.fileBytes());
            if (!reader.frames().empty())
            {
                const std::size_t last = reader.frames().size() - 1;
                EXPECT_EQ(reader.seek(last).centres, run_.frames[last].centres);
                EXPECT_EQ(reader.seek(last).states, run_.frames[last].states);
            }
            mostFrames_ = std::max(mostFrames_, reader.frames().size());
        }
        catch (const Error& error)
        {
            EXPECT_EQ(error.code(), ErrorCode::badData);
            ++refused_;
        }
    }
    test::TemporaryFolder folder_;
    RecordedRun run_;
    std::string bytes_;
    std::size_t mostFrames_ = 0;
    int refused_ = 0;
};

TEST_F(TornRunFile, IsReadUpToItsLastWholeRecordAtTwoHundredLengths)
{
    std::mt19937 random(7); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same lengths every time
    for (int i = 0; i < 200; ++i)
    {
        const std::size_t length = random() % bytes_.size();
        expectAPrefix(bytes_.substr(0, length), std::to_string(length));
    }
    EXPECT_GT(mostFrames_, run_.frames.size() / 2);
    EXPECT_LT(refused_, 200);
}

TEST_F(TornRunFile, IsReadUpToTheRecordInWhichAByteIsDamaged)
{
    std::mt19937 random(8); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same bytes every time
    std::string damaged = bytes_;
    for (int i = 0; i < 200; ++i)
    {
        const std::size_t at = random() % bytes_.size();
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
        expectAPrefix(damaged, std::to_string(at));
        damaged[at] = bytes_[at];
    }
    EXPECT_GT(mostFrames_, 0U);
}

TEST_F(TornRunFile, ShowsEachOfTenThousandFlippedBits)
{
    std::mt19937 random(9); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same bits every time
    const auto wholeBytes = [](std::string_view file)
    {
        std::size_t whole = file.starts_with(kRunFileMagic) ? kRunFileMagic.size() : 0;
        for (const Record& record : wholeRecords(file))
        {
            whole += sizeof record.header + record.bytes.size();
        }
        return whole;
    };
    ASSERT_EQ(wholeBytes(bytes_), bytes_.size());
    for (int i = 0; i < 10'000; ++i)
    {
        const std::size_t at = random() % bytes_.size();
        const char was = bytes_[at];
        bytes_[at] = static_cast<char>(was ^ (1 << random() % 8));
        ASSERT_LT(wholeBytes(bytes_), bytes_.size()) << "byte " << at;
        bytes_[at] = was;
    }
}

TEST_F(TornRunFile, OfAnotherVersionIsRefusedNamingBoth)
{
    for (const int version : {1, 3}) // 1: of Frostfill 0.2.0
    {
        bytes_[8] = static_cast<char>(version);
        writeFile(folder_ / "other.frost", bytes_);
        test::expectError(
            ErrorCode::badData, [&] { RunFileReader reader(folder_ / "other.frost"); },
            fmt::format("other.frost' is a run file of version {}", version), "version 2",
            "fill again");
    }
}

TEST_F(TornRunFile, OfAnotherKindIsRefusedInASentence)
{
    writeFile(folder_ / "other", "solid cube");
    try
    {
        RunFileReader reader(folder_ / "other");
        FAIL();
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.code(), ErrorCode::badData);
        EXPECT_NE(std::string(error.what()).find("is no run file"), std::string::npos);
    }
    EXPECT_THROW(RunFileReader(folder_ / "missing"), Error);
}

} // namespace
} // namespace frostfill
