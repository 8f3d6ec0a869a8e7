// SPDX-License-Identifier: MIT
#include "render/raster/tile_pipeline.hpp"
#include "support/drawn_with.hpp"
#include "support/pictures.hpp"

#include <frostfill/error.hpp>
#include <frostfill/renderer.hpp>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

using namespace testing_support;

/// Vendor and version of a description, without the backend: "NAME: RENDERER, VENDOR, ...".
std::string driverOf(const std::string& description)
{
    return description.substr(description.find(": ") + 2);
}

class Backends : public testing::Test
{
protected:
    Backends()
    {
        Numbers numbers;
        for (int i = 0; i < 40; ++i)
        {
            addSphere(snapshot,
                      {2 * numbers.next() - 1, 2 * numbers.next() - 1, 2 * numbers.next() - 1},
                      0.1 + 0.1 * numbers.next(), static_cast<SphereState>(i % 3));
        }
        settings.size = {320, 180};
        settings.title = "backends";
    }

    [[nodiscard]] Image draw(Backend backend, std::string& driver) const
    {
        RenderSettings own = settings;
        own.backend = backend;
        Renderer renderer(mesh, own);
        driver = driverOf(renderer.description());
        Image image;
        renderer.render(snapshot, image);
        return image;
    }

    void choose(Look look)
    {
        settings.style.look = look;
        settings.style.palette = paletteOf(look);
    }

    TriangleMesh mesh = boxMesh({1, 1, 1});
    Snapshot snapshot;
    RenderSettings settings;
};

TEST_F(Backends, EglDrawsTheBytesOfOsmesaOnTheSameMesa)
{
    if (!test::hasBackend("osmesa") || !test::hasBackend("egl"))
    {
        GTEST_SKIP() << "there is no OSMesa, or no EGL";
    }
    for (const Look look : {Look::clean, Look::studio})
    {
        choose(look);
        std::string driver;
        const Image reference = draw(Backend::osmesa, driver);
        std::string own;
        const Image image = draw(Backend::egl, own);
        if (own != driver)
        {
            GTEST_SKIP() << "EGL has another driver: " << own;
        }
        EXPECT_EQ(image.pixels, reference.pixels) << static_cast<int>(look);
    }
}

// Lines and corners on a boundary between pixels may fall to either side; all else may be rounded
// differently.
TEST_F(Backends, TheBuiltInOneDrawsThePicturesOfOsmesa)
{
    if (!test::openGl())
    {
        GTEST_SKIP() << test::kNoOpenGl;
    }
    std::string driver;
    for (const Look look : {Look::clean, Look::paper, Look::studio})
    {
        for (const bool orthographic : {false, true})
        {
            for (const auto& [samples, supersample] : {std::array{1, 1}, {4, 1}, {1, 3}})
            {
                choose(look);
                settings.camera.orthographic = orthographic;
                settings.samples = samples;
                settings.supersample = supersample;
                const Image reference = draw(*test::openGl(), driver);
                const Image image = draw(Backend::builtin, driver);
                const ImageDifference difference = compareImages(reference, image);
                const auto which = fmt::format("{}, {}, {}x{}", static_cast<int>(look),
                                               orthographic, samples, supersample);
                EXPECT_LT(difference.rootMeanSquare, 2) << which;
                EXPECT_LT(difference.pixelsApart, image.pixels.size() / 3 / 500) << which;
            }
        }
    }
}

// Nothing but the shadow on the ground is compared. Where triangles of it are smaller than pixels,
// OpenGL takes the colour of one that lies beside the pixel's middle.
TEST_F(Backends, TheBuiltInOneDrawsTheGroundOfOsmesa)
{
    if (!test::openGl())
    {
        GTEST_SKIP() << test::kNoOpenGl;
    }
    choose(Look::studio);
    settings.style.shell = settings.style.legend = false;
    snapshot = {};
    std::string driver;
    for (const bool orthographic : {false, true})
    {
        for (const double elevation : {60.0, 20.0, 4.0, -20.0})
        {
            settings.camera.orthographic = orthographic;
            settings.camera.elevation = elevation;
            const Image reference = draw(*test::openGl(), driver);
            const Image image = draw(Backend::builtin, driver);
            const ImageDifference difference = compareImages(reference, image);
            EXPECT_LT(difference.rootMeanSquare, 0.7) << orthographic << ", " << elevation;
            EXPECT_LE(difference.largest, elevation > 10 ? 4 : 12)
                << orthographic << ", " << elevation;
            const auto [least, most] =
                std::minmax_element(image.pixels.begin(), image.pixels.end());
            EXPECT_EQ(*most - *least > 40, elevation > 0) << orthographic << ", " << elevation;
        }
    }
}

// A hatch that fades on small spheres has to fade in the picture that is seen, not in the large one
// that is made small.
TEST_F(Backends, SupersamplingKeepsHowAPictureLooks)
{
    std::string driver;
    settings.style.shell = settings.style.legend = false;
    for (const Backend backend : test::backends())
    {
        settings.samples = 4;
        settings.supersample = 1;
        const Image usual = draw(backend, driver);
        settings.samples = 1;
        settings.supersample = 8;
        const Image fine = draw(backend, driver);
        EXPECT_LT(compareImages(usual, fine).rootMeanSquare, 4) << static_cast<int>(backend);
    }
}

TEST_F(Backends, TheBuiltInOneGivesTheSameBytesWithoutAvx2)
{
    if (!drawsWithAvx2)
    {
        GTEST_SKIP() << "this processor has no AVX2";
    }
    const Cutaway cut{Cutaway::Kind::wedge, {0, 0, 1}, 0, -30, 80};
    for (const auto& [look, cutaway] : {std::pair{Look::clean, Cutaway{}},
                                        {Look::studio, Cutaway{}},
                                        {Look::clean, cut},
                                        {Look::paper, Cutaway{}},
                                        {Look::paper, cut}})
    {
        for (const bool orthographic : {false, true})
        {
            for (const int samples : {1, 4})
            {
                choose(look);
                settings.style.cutaway = cutaway;
                settings.camera.orthographic = orthographic;
                settings.samples = samples;
                Image wide, narrow;
                TilePipeline(mesh, settings).draw(snapshot, wide);
                drawsWithAvx2 = false;
                TilePipeline(mesh, settings).draw(snapshot, narrow);
                drawsWithAvx2 = true;
                EXPECT_FALSE(wide.pixels.empty());
                EXPECT_EQ(wide.pixels, narrow.pixels)
                    << static_cast<int>(look) << ", " << orthographic << ", " << samples;
            }
        }
    }
}

// Seen from far below at first, the lamp is so low that the ground has no shadow.
TEST_F(Backends, TheBuiltInOneDrawsAGroundWithoutAShadow)
{
    if (!test::openGl())
    {
        GTEST_SKIP() << test::kNoOpenGl;
    }
    choose(Look::studio);
    settings.camera.elevation = -70;
    std::vector<Image> pictures;
    for (const Backend backend : {*test::openGl(), Backend::builtin})
    {
        settings.backend = backend;
        Renderer renderer(mesh, settings);
        Camera above = settings.camera;
        above.elevation = 30;
        renderer.setCamera(above);
        pictures.push_back(renderer.draw(snapshot));
    }
    const ImageDifference difference = compareImages(pictures[0], pictures[1]);
    EXPECT_LT(difference.rootMeanSquare, 2);
}

// Tiles are drawn by whichever core is free. A camera that moves draws all of them, each time.
TEST_F(Backends, TheBuiltInOneGivesTheSameBytesWithAnyNumberOfThreads)
{
    settings.backend = Backend::builtin;
    settings.size = {400, 300};
    for (int i = 0; i < 10000; ++i) // more than one core places
    {
        const Eigen::Vector3d cell(i % 22, (i / 22) % 22, (i / 484) % 22);
        addSphere(snapshot, (cell - Eigen::Vector3d::Constant(11)) / 11, 0.045,
                  i % 7 == 0 ? SphereState::discarded : SphereState::frozen);
    }
    for (const auto& [samples, look] :
         {std::pair{1, Look::clean}, {4, Look::clean}, {4, Look::studio}})
    {
        choose(look);
        settings.samples = samples;
        std::vector<std::vector<std::uint8_t>> pictures;
        for (const std::size_t threads : {1, 8})
        {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            tbb::task_arena arena(static_cast<int>(threads));
            arena.execute(
                [&]
                {
                    Renderer renderer(mesh, settings);
                    for (int k = 0; k < 3; ++k)
                    {
                        renderer.turn(20.0 * k);
                        pictures.push_back(renderer.draw(snapshot).pixels);
                    }
                });
        }
        ASSERT_EQ(pictures.size(), 6U);
        EXPECT_NE(pictures[0], pictures[1]);
        for (std::size_t k = 0; k < 3; ++k)
        {
            EXPECT_EQ(pictures[k], pictures[k + 3]) << samples << " samples, picture " << k;
        }
    }
}

TEST_F(Backends, ContextsOfTwoLibrariesTakeTurnsInOneThread)
{
    if (!test::hasBackend("osmesa") || !test::hasBackend("egl"))
    {
        GTEST_SKIP() << "there is no OSMesa, or no EGL";
    }
    RenderSettings other = settings;
    settings.backend = Backend::osmesa;
    other.backend = Backend::egl;
    Image alone;
    Renderer(mesh, settings).render(snapshot, alone);

    Renderer first(mesh, settings);
    Renderer second(mesh, other);
    Renderer third(mesh, other);
    for (Renderer* renderer : {&first, &second, &third, &first, &second})
    {
        Image image;
        renderer->render(snapshot, image);
        EXPECT_EQ(image.pixels, alone.pixels);
    }
}

TEST_F(Backends, ProbingTriesEveryOneAndSaysWhatIsMissing)
{
    const std::vector<BackendAttempt> attempts = probeBackends();
    ASSERT_EQ(attempts.size(), 2U);
    EXPECT_EQ(attempts[0].name, "osmesa");
    EXPECT_EQ(attempts[1].name, "egl");
    // Wherever no test has hidden it: otherwise all that compares with it would be skipped.
    EXPECT_EQ(attempts[0].works, std::getenv("FAULT_LIBRARY") == nullptr)
        << attempts[0].description;
    for (const BackendAttempt& attempt : attempts)
    {
        EXPECT_EQ(attempt.works, attempt.remedy.empty());
        if (attempt.works)
        {
            EXPECT_NE(attempt.description.find("OpenGL"), std::string::npos);
        }
        else
        {
            EXPECT_NE(attempt.description.find(attempt.name), std::string::npos);
        }
    }
}

// Other threads of the process may be reading it.
TEST_F(Backends, LeaveTheEnvironmentAsItIs)
{
    std::ifstream stream("/proc/self/environ", std::ios::binary);
    std::string atStart{std::istreambuf_iterator<char>(stream), {}};
    for (const Backend backend : test::backends())
    {
        std::string driver;
        (void)draw(backend, driver);
    }
    for (char** entry = environ; *entry != nullptr; ++entry)
    {
        const std::string words(*entry);
        EXPECT_TRUE(!words.starts_with("MESA_") || atStart.find(words) != std::string::npos)
            << words;
    }
}

} // namespace
} // namespace frostfill
