// SPDX-License-Identifier: MIT
#include "page/assemble.hpp"
#include "support/expect_error.hpp"
#include "unit/page/paged_run.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using test::expectError;
using test::readFile;
using test::writeFile;

class Pages : public ::testing::Test
{
protected:
    Pages() : run_(test::recordForPage(folder_.path())) {}
    [[nodiscard]] PageRequest request(const std::string& name = "view.html") const
    {
        PageRequest request;
        request.run = folder_.path();
        request.file = folder_ / name;
        return request;
    }
    test::TemporaryFolder folder_;
    test::RecordedRun run_;
};

TEST_F(Pages, HaveTheSameBytesEachTime)
{
    writePage(request("a.html"));
    writePage(request("b.html"));
    const std::string bytes = readFile(folder_ / "a.html");
    EXPECT_GT(bytes.size(), 10000U);
    EXPECT_EQ(bytes, readFile(folder_ / "b.html"));
}

TEST_F(Pages, LieBesideTheRunUnlessAnotherFileIsNamed)
{
    PageRequest plain;
    plain.run = folder_ / "run.frost";
    const PageResult result = writePage(plain);
    EXPECT_EQ(result.file, folder_ / "view.html");
    EXPECT_EQ(result.bytes, std::filesystem::file_size(result.file));
    EXPECT_EQ(result.frames, run_.numbers.size());
    EXPECT_EQ(result.keptFrames, result.frames);
    EXPECT_EQ(result.spheres, 40U);
    EXPECT_TRUE(result.ended);
    EXPECT_LE(result.errorOverRadius, 0.001);
    EXPECT_GT(result.errorOverRadius, 0.0004);
}

TEST_F(Pages, AskForNothingFromAnywhere)
{
    writePage(request());
    const std::string page = readFile(folder_ / "view.html");
    for (const char* word : {"http-equiv", "<link rel=\"stylesheet", "src=", "import(", "fetch("})
    {
        EXPECT_EQ(page.find(word), std::string::npos) << word;
    }
    // The name of a vocabulary, which nobody opens, is the only address.
    for (std::size_t at = page.find("://"); at != std::string::npos; at = page.find("://", at + 1))
    {
        EXPECT_EQ(page.substr(at, 18), "://www.w3.org/2000");
    }
}

TEST_F(Pages, ShowTheLastFrameAloneWhereMotionDoesNotFit)
{
    const PageResult whole = writePage(request("whole.html"));
    PageRequest small = request("small.html");
    small.maxBytes = whole.bytes - 1;
    const PageResult result = writePage(small);
    EXPECT_EQ(result.frames, 1U);
    EXPECT_EQ(result.keptFrames, whole.frames);
    EXPECT_EQ(result.motionBytes, whole.bytes);
    EXPECT_LT(result.bytes, whole.bytes);
    EXPECT_EQ(result.spheres, 40U);
}

TEST_F(Pages, AreRefusedWhereNotEvenTheLastFrameFits)
{
    PageRequest tiny = request();
    tiny.maxBytes = 5000;
    expectError(
        ErrorCode::usage, [&] { writePage(tiny); }, "last frame", "--max-size 1");
    EXPECT_FALSE(std::filesystem::exists(tiny.file));
}

TEST_F(Pages, ReplaceNothingUnasked)
{
    writeFile(folder_ / "view.html", "mine");
    expectError(
        ErrorCode::cannotCreate, [&] { writePage(request()); }, "view.html", "--overwrite",
        "--out");
    EXPECT_EQ(readFile(folder_ / "view.html"), "mine");
    PageRequest again = request();
    again.overwrite = true;
    writePage(again);
    EXPECT_NE(readFile(folder_ / "view.html"), "mine");
}

TEST_F(Pages, OfATornRunShowItsWholeFramesAndSaySo)
{
    const std::string bytes = readFile(folder_ / "run.frost");
    writeFile(folder_ / "run.frost", bytes.substr(0, bytes.size() - 40));
    const PageResult result = writePage(request());
    EXPECT_FALSE(result.ended);
    EXPECT_GT(result.frames, 0U);
    EXPECT_NE(readFile(folder_ / "view.html").find("\"summary\":null"), std::string::npos);
}

TEST_F(Pages, ThatAreStoppedLeaveNoPart)
{
    expectError(
        ErrorCode::stoppedEarly,
        [&] { writePage(request(), [](std::size_t done, std::size_t) { return done < 3; }); },
        "page");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "view.html"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "view.html.part"));
}

TEST_F(Pages, CannotBeMadeOfWhatIsNoRun)
{
    PageRequest missing = request();
    missing.run = folder_ / "nothing";
    expectError(
        ErrorCode::inputMissing, [&] { writePage(missing); }, "nothing");
    writeFile(folder_ / "text", "no run");
    missing.run = folder_ / "text";
    expectError(
        ErrorCode::badData, [&] { writePage(missing); }, "text");
    test::recordRun(test::fewSpheres(), folder_ / "strange.frost");
    missing.run = folder_ / "strange.frost";
    expectError(
        ErrorCode::badData, [&] { writePage(missing); }, "strange.frost");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "view.html"));
}

TEST(Base64, IsThatOfRfc4648)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

} // namespace
} // namespace frostfill
