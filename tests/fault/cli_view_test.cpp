// SPDX-License-Identifier: MIT
// The command view, and pages of fill, as their user meets them.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;
using test::writeFile;

const std::string kRun = "fill cube --radius 0.3 --count 8 --size 64x48 --duration 0.5 --out run ";

class ViewCommand : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    test::TemporaryFolder folder_;
};

TEST_F(ViewCommand, WritesAPageBesideTheRunAndSaysHowLargeItIs)
{
    ASSERT_EQ(run(kRun + "--quiet").code, 0);
    const Answer answer = run("view run");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.output.find("run/view.html"), std::string::npos) << answer.output;
    EXPECT_NE(answer.output.find(" frames, 8 spheres, "), std::string::npos) << answer.output;
    EXPECT_NE(answer.output.find(" MB; places are within 0.000"), std::string::npos)
        << answer.output;
    const Answer again = run("view run/run.frost");
    EXPECT_EQ(again.code, 73);
    EXPECT_NE(again.errors.find("--overwrite"), std::string::npos) << again.errors;
    EXPECT_EQ(run("view run --out other.html --quiet").output, "");
    EXPECT_EQ(readFile(folder_ / "other.html"), readFile(folder_ / "run/view.html"));
}

TEST_F(ViewCommand, SaysWhenMotionDoesNotFit)
{
    ASSERT_EQ(run(kRun + "--quiet").code, 0);
    const Answer small = run("view run --max-size 0.1");
    EXPECT_EQ(small.code, 64);
    const std::string size = "last frame alone";
    EXPECT_NE(small.errors.find(size), std::string::npos) << small.errors;
    EXPECT_NE(small.errors.find("--max-size"), std::string::npos) << small.errors;
}

TEST_F(ViewCommand, RefusesWhatItCannotRead)
{
    EXPECT_EQ(run("view nothing").code, 66);
    writeFile(folder_ / "text.frost", "no run");
    EXPECT_EQ(run("view text.frost").code, 65);
    EXPECT_EQ(run("view").code, 64);
    EXPECT_EQ(run("view text.frost --max-size 0").code, 64);
    ASSERT_EQ(run(kRun + "--quiet").code, 0);
    EXPECT_EQ(run("view run --out missing/page.html").code, 73);
}

TEST_F(ViewCommand, IsDoneByFillWhereAPageIsNamed)
{
    const std::string fill = "fill cube --radius 0.3 --count 8 --size 64x48 --set frames.limit=2 ";
    const Answer answer = run(fill + "--out page.html");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.errors.find("the run itself goes to output/cube"), std::string::npos)
        << answer.errors;
    EXPECT_NE(answer.output.find("page.html: "), std::string::npos) << answer.output;
    const std::string page = readFile(folder_ / "page.html");
    EXPECT_NE(page.find("\"outcome\":\"count reached\""), std::string::npos);
    EXPECT_EQ(run(fill + "--out page.html").code, 73);
    EXPECT_EQ(run(fill + "--frames none --overwrite --out page.html").code, 64);
    EXPECT_EQ(readFile(folder_ / "page.html"), page);
    const Answer kept = run(fill + "--frames none --overwrite --set frames.keep_run=true --quiet "
                                   "--out page.html");
    EXPECT_EQ(kept.code, 0) << kept.errors;
    EXPECT_EQ(kept.output + kept.errors, "");
}

} // namespace
} // namespace frostfill
