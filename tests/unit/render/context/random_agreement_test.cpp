// SPDX-License-Identifier: MIT
// Same means same: OSMesa and tiles beside each other, for scenes that nobody has chosen.
#include "support/drawn_with.hpp"
#include "support/shapes.hpp"
#include "unit/render/context/agreement.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/renderer.hpp>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace frostfill
{
namespace
{

using test::Numbers;
using test::Subject;

constexpr int kScenes = 60;
constexpr test::Apart kSame = {0.4, 4};

/// An outline may pass a sample so closely that single precision does not tell on which side: the
/// ray caster leaves out what is closer than a thousandth of a pixel. One such pixel in black on
/// white is a root mean square of 0.7 by itself.
constexpr std::size_t kOnOutlines = 5;
constexpr double kSameWithThem = 0.75;

/// As large as the others.
TriangleMesh fitted(TriangleMesh mesh)
{
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = 2.4 / box.diagonal().norm() * (vertex - box.center());
    }
    return mesh;
}

/// Meshes of twelve triangles to 60,000, with spheres from a tenth of the object to a hundredth.
/// They lie in the objects and around them, as if they had leaked: also where the picture begins.
std::vector<Subject> objects()
{
    return {test::subjectOf("torus", shapes::torus(1, 0.4, 24, 8), 0.3),
            test::subjectOf("dense torus", shapes::torus(1, 0.4, 300, 100), 0.2),
            test::subjectOf("box", testing_support::boxMesh({1, 0.8, 0.6}), 0.25),
            test::subjectOf("human", fitted(loadMesh("human").mesh), 0.08),
            test::subjectOf("sphere", fitted(loadMesh("sphere").mesh), 0.12)};
}

/// Polygons are discarded where the object is full: up to a height, which is not quite level.
void discardBelow(double height, double slope, Subject& subject)
{
    Snapshot& snapshot = subject.snapshot;
    snapshot.discardedPolygons = 0;
    for (std::size_t t = 0; t < subject.mesh.triangles.size(); ++t)
    {
        const Eigen::Vector3d& corner = subject.mesh.vertices[subject.mesh.triangles[t][0]];
        const bool below = corner.y() + slope * corner.x() < height;
        snapshot.polygons[t] = below ? PolygonState::discarded : PolygonState::active;
        snapshot.discardedPolygons += below ? 1 : 0;
    }
}

/// Any camera outside the spheres, any style, cut open or whole.
RenderSettings anySettings(Numbers& numbers)
{
    const auto between = [&](double low, double high)
    { return low + (high - low) * numbers.next(); };
    const auto isDrawn = [&](double share) { return numbers.next() < share; };
    RenderSettings settings;
    settings.size = {480, 270};
    settings.samples = isDrawn(0.5) ? 1 : 4;
    Style& style = settings.style;
    style.look = static_cast<Look>(static_cast<int>(4 * numbers.next()));
    style.palette = paletteOf(style.look);
    style.legend = isDrawn(0.5);
    style.shell = isDrawn(0.9);
    style.ambientOcclusion = isDrawn(0.25);
    if (isDrawn(0.4))
    {
        const double from = between(-180, 180);
        style.cutaway =
            isDrawn(0.5)
                ? Cutaway{Cutaway::Kind::plane,
                          {between(-1, 1), between(-1, 1), between(0.1, 1)},
                          between(-0.3, 0.3),
                          0,
                          90}
                : Cutaway{Cutaway::Kind::wedge, {0, 0, 1}, 0, from, from + between(30, 150)};
    }
    Camera& camera = settings.camera;
    camera.azimuth = between(-180, 180);
    camera.elevation = between(-80, 80);
    camera.fieldOfView = between(10, 90);
    camera.zoom = std::exp2(between(-1, 2));
    camera.orthographic = isDrawn(0.3);
    return settings;
}

Image drawnBy(Backend backend, RenderSettings settings, const Subject& subject)
{
    settings.backend = backend;
    Renderer renderer(subject.mesh, settings);
    return renderer.draw(subject.snapshot);
}

TEST(RandomAgreement, IsThereForSixtyScenes)
{
    if (!test::openGl())
    {
        GTEST_SKIP() << test::kNoOpenGl;
    }
    std::vector<Subject> all = objects();
    Numbers numbers, turns;
    for (Subject& subject : all)
    {
        for (std::size_t i = 0; i < subject.snapshot.centres.size(); ++i)
        {
            testing_support::turnSphere(subject.snapshot, i, testing_support::anyTurn(turns));
        }
    }
    double sum = 0;
    double most = 0;
    double mostWithAll = 0;
    for (int scene = 0; scene < kScenes; ++scene)
    {
        Subject& subject = all[static_cast<std::size_t>(scene) % all.size()];
        const RenderSettings settings = anySettings(numbers);
        const double height = 2 * numbers.next() - 1;
        discardBelow(height, numbers.next() - 0.5, subject);
        const Image osmesa = drawnBy(*test::openGl(), settings, subject);
        const Image tiles = drawnBy(Backend::builtin, settings, subject);
        const double rms = test::rmsBeside(osmesa, tiles, kOnOutlines);
        const double withAll = compareImages(osmesa, tiles).rootMeanSquare;
        const double region = test::worstRegion(osmesa, tiles);
        const std::string what = fmt::format(
            "scene {}: {}, look {}, cut {}, occlusion {}, samples {}: rms {:.2f}, region {:.1f}",
            scene, subject.name, static_cast<int>(settings.style.look),
            static_cast<int>(settings.style.cutaway.kind), settings.style.ambientOcclusion,
            settings.samples, rms, region);
        EXPECT_LE(rms, kSame.rms) << what;
        EXPECT_LE(withAll, kSameWithThem) << what;
        EXPECT_LE(region, kSame.region) << what;
        sum += rms;
        most = std::max(most, rms);
        mostWithAll = std::max(mostWithAll, withAll);
    }
    RecordProperty("rms", fmt::format("{:.2f} at most, {:.2f} in the mean; {:.2f} with all pixels",
                                      most, sum / kScenes, mostWithAll));
    fmt::print("rms {:.2f} at most, {:.2f} in the mean; {:.2f} with all pixels\n", most,
               sum / kScenes, mostWithAll);
}

} // namespace
} // namespace frostfill
