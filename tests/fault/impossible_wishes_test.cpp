// SPDX-License-Identifier: MIT
// What the program is asked for cannot be: names, sizes, views, values. Rows F16, F19 and F21 of
// docs/reliability.md.
#include "fault/environment.hpp"

#include <unistd.h>

#include <algorithm>
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
using test::writeFile;
namespace fs = std::filesystem;

// Each of these would simulate for minutes if it began.
TEST_F(Environment, NamesThatCannotBeWrittenAreRefusedBeforeTheSimulation)
{
    fs::create_directories(folder_ / "b/frames/frame_00000.png");
    writeFile(folder_ / "c", "a file");
    std::vector<std::string> names = {std::string(256, 'a'), "b", "c", "c/d", "/proc/none"};
    if (geteuid() != 0)
    {
        fs::create_directory(folder_ / "locked");
        fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
        names.push_back("locked");
    }
    for (const std::string& name : names)
    {
        const Answer answer = run(kLong + "--overwrite --out " + name, "timeout 60");
        EXPECT_EQ(answer.code, 73) << name << answer.errors;
    }
}

TEST_F(Environment, SizesThatCannotBeDrawnAreRefusedAndTheSmallestIsDrawn)
{
    for (const char* size : {"20000x20000", "0x0", "-5x5", "-5", "16385x1", "1e3x1e3"})
    {
        const Answer answer = run(kLong + "--out a --size=" + size, "timeout 60");
        EXPECT_EQ(answer.code, 64) << size << answer.errors;
    }
    EXPECT_FALSE(fs::exists(folder_ / "a"));
    EXPECT_EQ(
        run(kLong + "--quiet --size 16384x16384 --set picture.supersample=8 --out a", "timeout 60")
            .code,
        64);
    for (const char* size : {"1x1", "1x50", "50x1"})
    {
        const Answer answer =
            run("fill cube --count 4 --set frames.limit=2 --set threads=1 --quiet "
                "--overwrite --out b --size " +
                std::string(size));
        EXPECT_EQ(answer.code, 0) << size << answer.errors;
    }
}

TEST_F(Environment, VideosWithoutABackgroundAreRefusedWhereTheirFormatHasNoAlpha)
{
    for (const char* name : {"a.mp4", "a.gif"})
    {
        const Answer answer =
            run(kLong + "--background none --out a --video " + name, "timeout 60");
        EXPECT_EQ(answer.code, 64) << name << answer.errors;
        EXPECT_NE(answer.errors.find(".webm"), std::string::npos) << answer.errors;
    }
    EXPECT_FALSE(fs::exists(folder_ / "a"));
}

TEST_F(Environment, PicturesThatShowNothingAreTold)
{
    for (const char* view : {"--set camera.target=1e6,0,0",
                             "--azimuth 0 --set camera.target=0,0,50 --set camera.distance=1"})
    {
        const Answer answer = run(kSmall + "--quiet --overwrite --out a " + view);
        EXPECT_EQ(answer.code, 70) << view;
        EXPECT_NE(answer.errors.find("blank"), std::string::npos) << view << answer.errors;
        EXPECT_TRUE(fs::exists(folder_ / "a/spheres.csv")) << view;
    }
    // Inside the object the spheres are seen from between them.
    EXPECT_EQ(run(kSmall + "--quiet --overwrite --out a --set camera.distance=0.01").code, 0);
}

TEST_F(Environment, ValuesBeyondTheirRangeAreRefusedBeforeTheSimulation)
{
    for (const char* option : {"--set frames.slow_motion=1e9",
                               "--set frames.slow_motion=1e-300",
                               "--fps 1e-300",
                               "--fps 1e9",
                               "--radius 1e-300",
                               "--radius 1e-300..1",
                               "--radius 1e300",
                               "--set motion.gravity=1e300",
                               "--set motion.gravity=1e-300",
                               "--set motion.dt=1e-300",
                               "--zoom 1e-300",
                               "--zoom 1e9",
                               "--set camera.distance=1e300",
                               "--set camera.target=1e300,0,0",
                               "--turntable 1e-300",
                               "--set move.tilt=1e9",
                               "--set move.turn=1e9",
                               "--set move.shake=1e300",
                               "--set move.duration=1e300",
                               "--set move.duration=1e-300",
                               "--set move.frequency=1e300",
                               "--set freezing.set_time_limit=1e300",
                               "--set freezing.rest_window=1e300",
                               "--set threads=100000",
                               "--set picture.samples=64",
                               "--units 1e-300",
                               "--set frames.hold=1e9",
                               "--set motion.sweeps=1000000",
                               "--set spheres.group_size=1e9",
                               "--set discard.epsilon=1e300",
                               "--cutaway plane:1e300,0,0"})
    {
        const Answer answer = run(kLong + "--out a " + option, "timeout 60");
        EXPECT_EQ(answer.code, 64) << option << answer.errors;
        EXPECT_EQ(std::count(answer.errors.begin(), answer.errors.end(), '\n'), 1) << option;
    }
    writeFile(folder_ / "scene.toml", "[object]\nmesh = \"cube\"\n[frames]\nslow_motion = 1e9\n");
    const Answer file = run("fill scene.toml --out a", "timeout 60");
    EXPECT_EQ(file.code, 65) << file.errors;
    EXPECT_NE(file.errors.find("scene.toml, line 4"), std::string::npos) << file.errors;
    EXPECT_FALSE(fs::exists(folder_ / "a"));
}

} // namespace
} // namespace frostfill
