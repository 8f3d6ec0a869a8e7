// SPDX-License-Identifier: MIT
// A small picture with everything in it, against one that a person has looked at.
// FROSTFILL_UPDATE_GOLDEN=1 in the environment rewrites it; look at it again then.
#include "support/pictures.hpp"

#include "support/drawn_with.hpp"
#include "support/load_png.hpp"
#include "support/paths.hpp"

#include <frostfill/image.hpp>
#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace frostfill
{
namespace
{

using namespace testing_support;
namespace fs = std::filesystem;

/// The pictures are OSMesa's. Other versions of Mesa round differently along edges; what a person
/// would see is far beyond this.
constexpr double kLargestRms = 2;
/// What is drawn without OpenGL depends on no Mesa. Most is by colours over a clear background, of
/// which a small alpha makes much.
constexpr double kLargestRmsOfTiles = 0.8;

double largestRms()
{
    return test::drawnWith() == Backend::automatic ? kLargestRmsOfTiles : kLargestRms;
}

void expectLikeGolden(const Image& actual, const std::string& name)
{
    const fs::path golden = testing_support::sourceFolder() / "tests" / "golden" / (name + ".png");
    if (std::getenv("FROSTFILL_UPDATE_GOLDEN") != nullptr)
    {
        savePng(actual, golden);
        return;
    }
    const Image expected = loadPng(golden);
    const ImageDifference difference = compareImages(actual, expected);
    if (difference.sameShape && difference.rootMeanSquare <= largestRms())
    {
        return;
    }
    const fs::path output = testing_support::testOutput();
    savePng(actual, output / (name + "_actual.png"));
    ADD_FAILURE() << "differs from " << golden << "\n  drawn: " << output / (name + "_actual.png")
                  << "\n  root mean square " << difference.rootMeanSquare << " of 255, largest "
                  << difference.largest << ", pixels apart " << difference.pixelsApart;
}

/// Spheres of all states in layers on a ring, and polygons discarded at its foot.
Snapshot allStates(const TriangleMesh& mesh)
{
    Snapshot snapshot;
    for (int i = 0; i < 60; ++i)
    {
        // The golden angle along the ring, and a slow turn within the tube.
        const double around = 2.39996323 * i;
        const double ring = 1 + 0.2 * std::cos(0.7 * i);
        const Eigen::Vector3d centre(ring * std::cos(around), ring * std::sin(around),
                                     0.2 * std::sin(0.7 * i));
        addSphere(snapshot, centre, 0.15,
                  centre.y() > 0.55    ? SphereState::running
                  : centre.y() > -0.45 ? SphereState::frozen
                                       : SphereState::discarded);
    }
    for (const auto& triangle : mesh.triangles)
    {
        const double height = mesh.vertices[triangle[0]].y();
        snapshot.polygons.push_back(height < -0.8 ? PolygonState::discarded : PolygonState::active);
        snapshot.discardedPolygons += height < -0.8 ? 1 : 0;
    }
    snapshot.set = 3;
    snapshot.step = 1234;
    snapshot.time = 1.5;

    return snapshot;
}

/// Pairs of spheres that touch the tube of a ring from within, and each other nearly.
Snapshot alongTheWall(const Snapshot& all)
{
    Snapshot snapshot;
    snapshot.polygons = all.polygons;
    snapshot.discardedPolygons = all.discardedPolygons;
    for (int i = 0; i < 32; ++i)
    {
        const int pair = i / 2;
        const double around = 2 * M_PI / 16 * pair;
        const double ring = 1.13;
        const Eigen::Vector3d centre(ring * std::cos(around), ring * std::sin(around),
                                     i % 2 == 0 ? 0.19 : -0.19);
        addSphere(snapshot, centre, 0.16,
                  centre.y() > 0.6    ? SphereState::running
                  : centre.y() > -0.6 ? SphereState::frozen
                                      : SphereState::discarded);
    }
    return snapshot;
}

/// Where spheres overlap, a cut through both shows either: smaller, they do not.
Snapshot apart(Snapshot snapshot)
{
    float least = 1;
    for (std::size_t i = 0; i < snapshot.centres.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            least = std::min(least, (snapshot.centres[i] - snapshot.centres[j]).norm());
        }
    }
    std::fill(snapshot.radii.begin(), snapshot.radii.end(), least / 2);
    return snapshot;
}

class GoldenPictures : public testing::Test
{
protected:
    GoldenPictures()
    {
        settings.backend = test::drawnWith();
        settings.size = {320, 180};
        settings.title = "torus";
    }
    [[nodiscard]] Image draw() const
    {
        Image image;
        Renderer(mesh, settings).render(snapshot, image);
        return image;
    }

    TriangleMesh mesh = torusMesh(1, 0.4, 32, 12);
    Snapshot snapshot = allStates(mesh);
    RenderSettings settings;
};

TEST_F(GoldenPictures, AllStatesInATorus)
{
    expectLikeGolden(draw(), "all_states");
}

TEST_F(GoldenPictures, CutOpenOnPaperWithShades)
{
    settings.style.look = Look::paper;
    settings.style.palette = paletteOf(Look::paper);
    settings.style.cutaway = {Cutaway::Kind::plane, {0, 0, 1}, 0.05, 0, 90};
    settings.style.ambientOcclusion = true;
    settings.supersample = 2;
    snapshot = apart(snapshot);
    expectLikeGolden(draw(), "cut_paper");
}

TEST_F(GoldenPictures, HeightsInTheDark)
{
    settings.style.look = Look::dark;
    settings.style.palette = paletteOf(Look::dark);
    settings.style.colourBy = "height";
    settings.size = {480, 270}; // room for the scale
    expectLikeGolden(draw(), "heights_dark");
}

TEST_F(GoldenPictures, InTheStudio)
{
    settings.style.look = Look::studio;
    settings.style.palette = paletteOf(Look::studio);
    settings.size = {480, 270};
    snapshot = alongTheWall(snapshot);
    expectLikeGolden(draw(), "studio");
}

TEST_F(GoldenPictures, NothingBehind)
{
    settings.style.palette.background[3] = 0;
    expectLikeGolden(draw(), "transparent");
}

} // namespace
} // namespace frostfill
