// SPDX-License-Identifier: MIT
// What a page holds is read by others: by hand with Python's standard library; by Node.js, where it
// is installed, which runs what needs no browser; and by Chromium, where it is installed, which
// shows the page and is compared with our own pictures.
#include "unit/page/paged_run.hpp"

#include <frostfill/render_run.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

namespace frostfill
{
namespace
{

using test::readFile;
using test::writeFile;

int run(const std::string& command)
{
    return std::system(command.c_str()); // NOLINT(cert-env33-c): of our own words
}

/// Runs a script of the readers on a folder; what it prints goes into the test's output.
void read(const char* script, const test::TemporaryFolder& folder,
          const char* with = "/usr/bin/python3")
{
    const std::string said = (folder / "said.txt").string();
    EXPECT_EQ(run(fmt::format("{} '{}/{}' '{}' >'{}' 2>&1", with, FROSTFILL_PAGE_READERS, script,
                              folder.path().string(), said)),
              0)
        << readFile(said);
    std::cout << readFile(said);
}

class PageReaders : public ::testing::TestWithParam<bool>
{
};

TEST_P(PageReaders, FindEverySphereWithinTheErrorThatThePageStates)
{
    const test::TemporaryFolder folder;
    test::recordForPage(folder.path(), GetParam());
    PageRequest request;
    request.run = folder.path();
    writePage(request);
    read("by_hand.py", folder);
}

INSTANTIATE_TEST_SUITE_P(OfAMovedObject, PageReaders, ::testing::Bool());

TEST(PageReadersOfAnything, FollowSpheresThatWaitWakeAndAreWithdrawn)
{
    const test::TemporaryFolder folder;
    const test::EventfulRun run(folder.path());
    PageRequest request;
    request.run = folder.path();
    writePage(request);
    read("by_hand.py", folder);
}

/// Of a still torus, of a moved one, or of one in which everything happens.
class InNode : public ::testing::TestWithParam<const char*>
{
};

TEST_P(InNode, PagesDecodeEveryFrameAndPlaceTheCamera)
{
    if (run("node --version | grep -qE '^v(1[89]|[2-9][0-9])'") != 0)
    {
        GTEST_SKIP() << "Node.js 18 is not installed (apt-get install nodejs)";
    }
    const test::TemporaryFolder folder;
    const std::string kind = GetParam();
    if (kind == "Eventful")
    {
        const test::EventfulRun eventful(folder.path());
    }
    else
    {
        test::recordForPage(folder.path(), kind == "Moved");
    }
    PageRequest request;
    request.run = folder.path();
    writePage(request);
    read("in_node.mjs", folder, "node");
}

INSTANTIATE_TEST_SUITE_P(Runs, InNode, ::testing::Values("Still", "Moved", "Eventful"),
                         [](const auto& run) { return std::string(run.param); });

/// Our own pictures of three frames, drawn as pages draw: twice as wide and high, then averaged.
void drawFrames(const std::filesystem::path& folder, const std::vector<std::size_t>& frames,
                Look look, const std::string& name)
{
    RenderRequest request;
    request.run = folder;
    request.directory = folder / name;
    request.change = [&](Scene& scene)
    {
        scene.style.look = look;
        scene.style.palette = paletteOf(look);
        scene.frames.selection = fmt::format("{}", fmt::join(frames, ","));
        scene.size = {320, 240};
        scene.samples = 1;
        scene.supersample = 2;
        scene.style.legend = false;
        scene.camera.azimuth = 50;
        scene.camera.elevation = 35;
        scene.camera.target = Eigen::Vector3d(0.1, 0.2, -0.1);
        scene.camera.distance = 5;
    };
    ASSERT_EQ(renderRun(request).frames, frames.size());
}

bool chromiumIsThere()
{
    return run("(command -v chromium || command -v chromium-browser || command -v google-chrome) "
               ">/dev/null 2>&1") == 0;
}

class InChromium : public ::testing::TestWithParam<bool>
{
};

TEST_P(InChromium, PagesLookLikeOurPicturesAndAnswerToHands)
{
    if (!chromiumIsThere())
    {
        GTEST_SKIP() << "chromium is not installed";
    }
    const test::TemporaryFolder folder;
    const test::RecordedRun recorded = test::recordForPage(folder.path(), GetParam());
    const std::size_t last = recorded.numbers.size() - 1;
    const std::vector<std::size_t> frames = {recorded.numbers[last / 4], recorded.numbers[last / 2],
                                             recorded.numbers[last - 1]};
    drawFrames(folder.path(), frames, Look::clean, "Clean");
    drawFrames(folder.path(), frames, Look::paper, "Paper");
    const nlohmann::json facts = {
        {"frames", frames},
        {"size", "320x240"},
        {"camera", "azimuth=50&elevation=35&target=0.1,0.2,-0.1&distance=5"},
        {"looks", {"Clean", "Paper"}}};
    writeFile(folder / "pictures.json", facts.dump());
    PageRequest request;
    request.run = folder.path();
    writePage(request);
    read("in_chromium.py", folder);
}

INSTANTIATE_TEST_SUITE_P(OfAMovedObject, InChromium, ::testing::Bool());

TEST(InChromiumAnything, IsDecodedForwardsAndBackwards)
{
    if (!chromiumIsThere())
    {
        GTEST_SKIP() << "chromium is not installed";
    }
    const test::TemporaryFolder folder;
    const test::EventfulRun eventful(folder.path());
    PageRequest request;
    request.run = folder.path();
    writePage(request);
    read("film_in_chromium.py", folder);
}

} // namespace
} // namespace frostfill
