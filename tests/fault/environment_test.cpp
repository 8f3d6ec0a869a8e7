// SPDX-License-Identifier: MIT
// What is around the program goes wrong: signals, streams, libraries, programs, locales, clocks.
// Rows F2, F12, F14, F15, F17 and F18 of docs/reliability.md.
#include "fault/environment.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;
using test::Environment;
using test::kLong;
using test::kSmall;
using test::readFile;
using test::writeFile;
namespace fs = std::filesystem;

double secondsOf(const std::function<void()>& what)
{
    const auto start = std::chrono::steady_clock::now();
    what();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// [s] In which a run stops on a machine that does other work; alone it takes a fraction of a
/// second.
#ifdef FROSTFILL_SANITIZED
constexpr double kPatience = 60;
#else
constexpr double kPatience = 15;
#endif

TEST_F(Environment, ASignalAtAnyMomentEndsTheRunSoonAndWhole)
{
    int moment = 0;
    for (const char* signal : {"USR1", "TERM", "INT", "HUP", "USR1", "TERM"})
    {
        const double wait = 0.35 * ++moment;
        Answer answer;
        const double took = secondsOf(
            [&]
            {
                answer =
                    run(fmt::format("{}--quiet --out {} & process=$!; until test -d {}/frames; "
                                    "do sleep 0.05; done; sleep {}; kill -{} $process; "
                                    "wait $process",
                                    kLong, moment, moment, wait, signal));
            });
        EXPECT_LT(took, wait + kPatience) << signal;
        EXPECT_EQ(answer.code, 75) << signal << answer.errors;
        EXPECT_EQ(answer.errors, "") << signal;
        const auto summary = nlohmann::json::parse(
            readFile(folder_ / fmt::format("{}/summary.json", moment)), nullptr, false);
        ASSERT_TRUE(summary.is_object()) << signal;
        EXPECT_EQ(summary["outcome"], "stopped");
    }
}

TEST_F(Environment, TheTableOfARunThatWasStoppedHasTheSpheresThatThereAre)
{
    const Answer answer = run("fill cube --count 3000 --frames last --motion descend --rest joint "
                              "--out a & process=$!; until test -d a; do sleep 0.05; done; "
                              "sleep 1; kill -TERM $process; wait $process");
    EXPECT_EQ(answer.code, 75) << answer.errors;
    std::smatch counts;
    ASSERT_TRUE(std::regex_search(answer.output, counts,
                                  std::regex("\n +all .*\\| +([0-9]+) +([0-9]+) +([0-9]+)\n")))
        << answer.output;
    const auto summary = nlohmann::json::parse(readFile(folder_ / "a/summary.json"));
    EXPECT_EQ(summary["spheres"]["running"], std::stoul(counts[1]));
    EXPECT_EQ(summary["spheres"]["frozen"], std::stoul(counts[2]));
    EXPECT_EQ(summary["spheres"]["discarded"], std::stoul(counts[3]));
    EXPECT_GT(summary["spheres"]["total"], 0);
}

// Where no library of OpenGL can be opened, of whatever name.
TEST_F(Environment, WithoutAnyOpenGlEveryPictureIsDrawnToTheSameBytes)
{
    if (!hasShim())
    {
        GTEST_SKIP() << "a sanitizer has to be the first library that is loaded";
    }
    const std::string none = shim("FAULT_LIBRARY=lib");
    ASSERT_EQ(run(kSmall + "--quiet --out run").code, 0);
    int number = 0;
    for (const char* style : {"clean", "paper", "dark", "studio"})
    {
        for (const char* more : {"", "--cutaway plane:0,0,1 --set frames.passes=all",
                                 "--set picture.ambient_occlusion=true --set picture.supersample=2 "
                                 "--color-by contacts"})
        {
            const std::string options =
                fmt::format("render run --frames last --quiet --style {} {} --out ", style, more);
            const std::string with = fmt::format("with{}", number);
            const std::string without = fmt::format("without{}", number++);
            ASSERT_EQ(run(options + with).code, 0) << options;
            const Answer answer = run(options + without, none);
            EXPECT_EQ(answer.code, 0) << options << answer.errors;
            int files = 0;
            for (const auto& entry : fs::recursive_directory_iterator(folder_ / with))
            {
                if (entry.path().extension() == ".png")
                {
                    const fs::path same = fs::relative(entry.path(), folder_ / with);
                    EXPECT_TRUE(readFile(entry.path()) == readFile(folder_ / without / same))
                        << options << same;
                    ++files;
                }
            }
            EXPECT_GE(files, *more == '-' && more[2] == 'c' ? 4 : 1) << options;
        }
    }
    const Answer doctor = run("doctor", none);
    EXPECT_EQ(doctor.code, 0);
    EXPECT_NE(doctor.output.find("no OpenGL is available"), std::string::npos) << doctor.output;
}

TEST_F(Environment, WithoutTheOpenGlThatWasAskedForItSaysWhatToInstall)
{
    if (!hasShim())
    {
        GTEST_SKIP() << "a sanitizer has to be the first library that is loaded";
    }
    const Answer answer =
        run(kSmall + "--set picture.backend=osmesa --out a", shim("FAULT_LIBRARY=libOSMesa"));
    EXPECT_EQ(answer.code, 69);
    EXPECT_NE(answer.errors.find("apt install libosmesa6"), std::string::npos) << answer.errors;
    const Answer doctor = run("doctor", shim("FAULT_LIBRARY=libOSMesa"));
    EXPECT_EQ(doctor.code, 0);
    EXPECT_EQ(doctor.output.find("all is well"), std::string::npos) << doctor.output;
    EXPECT_NE(doctor.output.find("OSMesa is missing"), std::string::npos) << doctor.output;
    EXPECT_NE(doctor.output.find("apt install libosmesa6"), std::string::npos) << doctor.output;
    EXPECT_NE(run("doctor").output.find("all is well"), std::string::npos);
    const Answer fps = run("fps cube --count 21 --repeats 1 --quiet --searches grid",
                           shim("FAULT_LIBRARY=libOSMesa"));
    EXPECT_NE(fps.output.find("OSMesa is not measured: "), std::string::npos) << fps.output;
    EXPECT_NE(fps.output.find("apt install libosmesa6"), std::string::npos) << fps.output;
}

TEST_F(Environment, WithTooLittleMemoryForOpenGlItSaysSoAndDoesNotHang)
{
    if (!hasShim())
    {
        GTEST_SKIP() << "a sanitizer takes terabytes of address space";
    }
    std::set<int> codes;
    for (const int mebibytes : {150, 300, 500, 900})
    {
        const Answer answer =
            run(kSmall + fmt::format("--set picture.backend=osmesa --quiet --out {}", mebibytes),
                fmt::format("ulimit -v {}; timeout 100", 1024 * mebibytes));
        EXPECT_TRUE(answer.code == 71 || answer.code == 0)
            << mebibytes << " MiB: " << answer.code << answer.errors;
        codes.insert(answer.code);
    }
    EXPECT_EQ(codes.count(71), 1U) << "none was too little";
}

TEST_F(Environment, WithTooLittleMemoryForThreadsItNamesTheLimitOnMemory)
{
    if (!hasShim())
    {
        GTEST_SKIP() << "a sanitizer takes terabytes of address space";
    }
    for (int megabytes = 70; megabytes <= 150; megabytes += 10)
    {
        const Answer answer = run(kSmall + "--quiet --overwrite --out a",
                                  fmt::format("ulimit -v {};", 1000 * megabytes));
        EXPECT_TRUE(answer.code == 71 || answer.code == 0) << megabytes << answer.errors;
        EXPECT_EQ(answer.errors.find("ulimit -u"), std::string::npos)
            << megabytes << " MB: " << answer.errors;
    }
}

TEST_F(Environment, WithoutAPlaceForCompiledShadersItDrawsTheSamePictures)
{
    ASSERT_EQ(run(kSmall + "--set picture.backend=osmesa --quiet --out none",
                  "XDG_CACHE_HOME=/dev/null/x")
                  .code,
              0);
    const std::string kept = fmt::format("XDG_CACHE_HOME={}", (folder_ / "cache").string());
    ASSERT_EQ(run(kSmall + "--set picture.backend=osmesa --quiet --out first", kept).code, 0);
    EXPECT_TRUE(std::filesystem::is_directory(folder_ / "cache/frostfill"));
    ASSERT_EQ(run(kSmall + "--set picture.backend=osmesa --quiet --out second", kept).code, 0);
    for (const char* directory : {"first", "second"})
    {
        EXPECT_TRUE(readFile(folder_ / "none/frames/frame_00000.png") ==
                    readFile(folder_ / directory / "frames/frame_00000.png"))
            << directory;
    }
}

TEST_F(Environment, AClosedOutputIsAFailedWriteAndHarmsNoFile)
{
    ASSERT_EQ(run(kSmall + "--quiet --out whole").code, 0);
    EXPECT_EQ(run(kSmall + "--out closed >&-").code, 74);
    EXPECT_EQ(run(kSmall + "--json --out json >&-").code, 74);
    EXPECT_EQ(run(kSmall + "--out errors 2>&-").code, 0);
    EXPECT_EQ(run(kSmall + "--out all <&- >&- 2>&-").code, 74);
    for (const char* directory : {"closed", "json", "errors", "all"})
    {
        for (const char* file : {"spheres.csv", "mesh.ply", "frames/frame_00000.png"})
        {
            EXPECT_TRUE(readFile(folder_ / "whole" / file) == readFile(folder_ / directory / file))
                << directory << "/" << file;
        }
    }
}

TEST_F(Environment, AReaderThatGoesAwayOrIsSlowLosesNoRun)
{
    EXPECT_EQ(
        run(kSmall + "--out gone 2>&1 | head -c 1 >/dev/null; test -s gone/summary.json").code, 0);
    const Answer slow = run(kSmall + "--json --out slow | (sleep 1; cat)");
    EXPECT_EQ(slow.output, readFile(folder_ / "slow/summary.json"));
}

TEST_F(Environment, AVideoNeedsFfmpegAndAFfmpegThatDiesCostsTheVideoOnly)
{
    EXPECT_EQ(run(kSmall + "--quiet --out none --video film.mp4", "PATH=/nowhere").code, 73);
    EXPECT_FALSE(fs::exists(folder_ / "none/summary.json"));
    ASSERT_EQ(run(kSmall + "--quiet --out whole").code, 0);
    makeFfmpeg("head -c 5000 >/dev/null\nkill -9 $$\n");
    const Answer killed = run(kSmall + "--quiet --out killed --video film.mp4",
                              "PATH='" + (folder_ / "bin").string() + "':/bin:/usr/bin");
    EXPECT_EQ(killed.code, 74) << killed.errors;
    EXPECT_FALSE(fs::exists(folder_ / "film.mp4"));
    EXPECT_EQ(readFile(folder_ / "killed/frames/frame_00001.png"),
              readFile(folder_ / "whole/frames/frame_00001.png"));
}

TEST_F(Environment, TheNextRunClearsAwayTheVideoOfAKilledOne)
{
    makeFfmpeg("for last; do :; done\ncat >\"${last#file:}\"\n");
    const std::string path = "PATH='" + (folder_ / "bin").string() + "':/bin:/usr/bin";
    const Answer killed =
        run(kLong + "--quiet --out a --video film.mp4 & process=$!; until test -s film.part.mp4; "
                    "do sleep 0.05; done; kill -9 $process; wait $process",
            path);
    EXPECT_EQ(killed.code, 128 + 9) << killed.errors;
    EXPECT_FALSE(fs::exists(folder_ / "film.mp4"));
    EXPECT_EQ(run(kSmall + "--quiet --out b --video film.mp4", path).code, 0);
    EXPECT_GT(fs::file_size(folder_ / "film.mp4"), 0U);
    EXPECT_FALSE(fs::exists(folder_ / "film.part.mp4"));
}

TEST_F(Environment, LocaleTimeZoneAndClockChangeNoByte)
{
    ASSERT_EQ(run(kSmall + "--quiet --out plain").code, 0);
    const auto expectSame = [&](const std::string& directory)
    {
        for (const char* file :
             {"spheres.csv", "polygons.csv", "mesh.ply", "frames/frame_00002.png"})
        {
            EXPECT_TRUE(readFile(folder_ / "plain" / file) == readFile(folder_ / directory / file))
                << directory << "/" << file;
        }
    };
    EXPECT_EQ(run(kSmall + "--quiet --out german",
                  "LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8 TZ=Pacific/Chatham")
                  .code,
              0);
    expectSame("german");
    for (const char* seconds : {"3600", "86400"})
    {
        if (!hasShim())
        {
            GTEST_SKIP() << "a sanitizer has to be the first library that is loaded";
        }
        const std::string directory = std::string("clock") + seconds;
        const Answer answer =
            run(kSmall + "--out " + directory, shim(std::string("FAULT_CLOCK=") + seconds));
        EXPECT_EQ(answer.code, 0) << answer.errors;
        EXPECT_FALSE(std::regex_search(answer.errors + answer.output, std::regex(" -[0-9]")))
            << answer.errors << answer.output;
        expectSame(directory);
    }
}

TEST_F(Environment, EveryFrameTakesAsManyHandlesThreadsAndBytesAsTheOneBefore)
{
#ifdef FROSTFILL_SANITIZED
    GTEST_SKIP() << "a sanitizer keeps what was freed";
#endif
    // Handles, threads and kilobytes after some 100 frames and near the end of some 1,500.
    const Answer answer =
        run("fill cube --count 400 --size 160x90 --set frames.limit=0 --set frames.slow_motion=60 "
            "--set threads=1 "
            "--quiet --out a & process=$!; for frame in 00100 01400; do until test -e "
            "a/frames/frame_$frame.png; do kill -0 $process || exit 9; sleep 0.02; done; "
            "ls /proc/$process/fd | wc -l; ls /proc/$process/task | wc -l; "
            "grep -o 'VmRSS.*' /proc/$process/status | tr -dc '0-9\\n'; done; "
            "kill -TERM $process; wait $process; true");
    ASSERT_EQ(answer.code, 0) << answer.errors;
    std::istringstream text(answer.output);
    std::vector<long> early(3);
    std::vector<long> late(3);
    text >> early[0] >> early[1] >> early[2] >> late[0] >> late[1] >> late[2];
    ASSERT_TRUE(text) << answer.output;
    EXPECT_LE(std::abs(late[0] - early[0]), 2) << "a picture may just be open";
    EXPECT_EQ(late[1], early[1]);
    EXPECT_LT(late[2] - early[2], 5000);
}

} // namespace
} // namespace frostfill
