// SPDX-License-Identifier: MIT
// Spheres as OpenGL and as tiles draw them, against a ray caster in double precision.
#include "render/layer/painter_settings.hpp"
#include "render/layer/projected_sphere.hpp"
#include "render/pipeline.hpp"
#include "render/raster/has_avx2.hpp"
#include "render/raster/sphere_raster.hpp"
#include "render/raster/tile_grid.hpp"
#include "support/drawn_with.hpp"
#include "support/pictures.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace frostfill
{
namespace
{

using namespace testing_support;

/// Pixels whose ray passes an outline this closely may go either way [pixel].
constexpr double kEdgeTolerance = 1e-3;

struct Ray
{
    glm::dvec3 origin, direction; ///< in unit space; direction has length 1
};

struct Hit
{
    double distance = std::numeric_limits<double>::infinity();
    double radius = 0;
    bool onEdge = false; ///< of any sphere: the pixel proves nothing
};

/// The textbook, in double precision.
class RayCaster
{
public:
    RayCaster(const Framing& framing, const PictureSize& size)
        : size_(size), toUnit_(glm::inverse(framing.projection * framing.view)),
          pixelScale_(framing.projection[1][1] * size.height / 2),
          orthographic_(framing.orthographic)
    {
    }

    [[nodiscard]] Ray through(double x, double y) const
    {
        const glm::dvec3 near = unproject(x, y, 0);
        return {near, glm::normalize(unproject(x, y, 1) - near)};
    }

    [[nodiscard]] glm::dvec3 unproject(double x, double y, double windowDepth) const
    {
        const glm::dvec4 clip(2 * x / size_.width - 1, 1 - 2 * y / size_.height,
                              2 * windowDepth - 1, 1);
        const glm::dvec4 point = toUnit_ * clip;
        return glm::dvec3(point) / point.w;
    }

    [[nodiscard]] Hit cast(const Ray& ray, std::span<const SphereInstance> spheres) const
    {
        Hit hit;
        for (const SphereInstance& sphere : spheres)
        {
            const glm::dvec3 centre(sphere.x, sphere.y, sphere.z);
            const double radius = sphere.radius;
            const double along = glm::dot(centre - ray.origin, ray.direction);
            const double miss = glm::length(centre - ray.origin - along * ray.direction);
            // A length of 1 is at least this many pixels; the eye is some units away.
            const double pixels = std::abs(miss - radius) * pixelScale_ / (orthographic_ ? 1 : 8);
            hit.onEdge = hit.onEdge || pixels < kEdgeTolerance;
            const double distance = along - std::sqrt(std::max(radius * radius - miss * miss, 0.0));
            if (miss < radius && distance < hit.distance)
            {
                hit.distance = distance;
                hit.radius = radius;
            }
        }
        return hit;
    }

private:
    PictureSize size_;
    glm::dmat4 toUnit_;
    double pixelScale_;
    bool orthographic_;
};

/// Spheres about the object's centre [object's half width].
struct Cloud
{
    int count = 60;
    double spread = 1;
    double smallest = 0.02;
    double largest = 0.22;
};

/// What the depths of a picture may be off by [radius].
constexpr double kDepthTolerance = 0.002;

/// What was drawn where: the points that are seen in the middles of pixels, in unit space.
struct Drawn
{
    Framing framing;
    std::vector<SphereInstance> spheres;
    std::vector<std::optional<glm::dvec3>> points; ///< by rows from the top
};

Drawn drawWithOpenGl(const TriangleMesh& mesh, const RenderSettings& settings,
                     const Snapshot& snapshot)
{
    Pipeline pipeline(mesh, settings);
    pipeline.draw(snapshot);
    const auto spheres = pipeline.spheres().resting();
    Drawn drawn{pipeline.framing(), {spheres.begin(), spheres.end()}, {}};
    const RayCaster caster(drawn.framing, settings.size);
    const std::vector<double> depth = pipeline.readDepth();
    for (std::size_t i = 0; i < depth.size(); ++i)
    {
        const auto width = static_cast<std::size_t>(settings.size.width);
        drawn.points.push_back(depth[i] < 1 ? std::optional(caster.unproject(
                                                  static_cast<double>(i % width) + 0.5,
                                                  static_cast<double>(i / width) + 0.5, depth[i]))
                                            : std::nullopt);
    }
    return drawn;
}

Drawn drawInTiles(const TriangleMesh& mesh, const RenderSettings& settings,
                  const Snapshot& snapshot)
{
    Viewpoint viewpoint(mesh, settings);
    viewpoint.follow(snapshot);
    const Framing& framing = viewpoint.framing();
    SphereDrawList ledger;
    ledger.update(snapshot, framing, viewpoint.colours());
    const auto spheres = ledger.resting();
    Drawn drawn{framing, {spheres.begin(), spheres.end()}, {}};
    const SphereRaster raster(uniformsOf(framing, settings), framing.orthographic, settings.size,
                              settings.style.palette.background, 1, lanes::hasAvx2());
    const SphereProjector projector(framing, settings.size);
    const TileGrid grid(settings.size);
    const RayCaster caster(framing, settings.size);
    const auto width = static_cast<std::size_t>(settings.size.width);
    drawn.points.resize(width * static_cast<std::size_t>(settings.size.height));
    SampleTile tile;
    for (std::size_t t = 0; t < grid.count(); ++t)
    {
        const TilePart part = grid.part(t);
        tile.inverseDepth[0].fill(kNothing);
        for (const SphereInstance& sphere : spheres)
        {
            raster.draw(sphere, projector.project(sphere).pixels, part, tile);
        }
        const PixelRectangle inside = grid.inPicture(part);
        for (int y = inside.bottom; y < inside.top; ++y)
        {
            for (int x = inside.left; x < inside.right; ++x)
            {
                const double near = tile.inverseDepth[0][static_cast<std::size_t>(
                    (y - part.bottom) * kTileEdge + x - part.left)];
                if (near > kNothing)
                {
                    const int row = settings.size.height - 1 - y;
                    const Ray ray = caster.through(x + 0.5, row + 0.5);
                    // How far ahead of the eye the ray starts, and how much farther it goes.
                    const double from = -(framing.view * glm::dvec4(ray.origin, 1)).z;
                    const double along = -(framing.view * glm::dvec4(ray.direction, 0)).z;
                    const double ahead = framing.orthographic ? -near : 1 / near;
                    drawn.points[static_cast<std::size_t>(row) * width +
                                 static_cast<std::size_t>(x)] =
                        ray.origin + (ahead - from) / along * ray.direction;
                }
            }
        }
    }
    return drawn;
}

void compare(const Drawn& drawn, const PictureSize& size)
{
    const RayCaster caster(drawn.framing, size);
    std::size_t covered = 0;
    std::size_t onEdge = 0;
    std::size_t wrong = 0;
    double worst = 0;
    for (std::size_t i = 0; i < drawn.points.size(); ++i)
    {
        const auto width = static_cast<std::size_t>(size.width);
        const Ray ray = caster.through(static_cast<double>(i % width) + 0.5,
                                       static_cast<double>(i / width) + 0.5);
        const Hit hit = caster.cast(ray, drawn.spheres);
        const bool isHit = std::isfinite(hit.distance);
        if (hit.onEdge)
        {
            ++onEdge;
            continue;
        }
        covered += isHit ? 1 : 0;
        wrong += isHit != drawn.points[i].has_value() ? 1 : 0;
        if (isHit && drawn.points[i])
        {
            const glm::dvec3 exact = ray.origin + hit.distance * ray.direction;
            worst = std::max(worst, glm::length(*drawn.points[i] - exact) / hit.radius);
        }
    }
    EXPECT_GT(covered, 10000U) << "the scene proves little";
    EXPECT_LT(onEdge, covered / 100) << "the scene proves little";
    EXPECT_EQ(wrong, 0U);
    EXPECT_LT(worst, kDepthTolerance) << "depth error over radius";
}

void compare(RenderSettings settings, const Cloud& cloud = {})
{
    settings.style.shell = false;
    settings.style.legend = false;
    settings.samples = 1;
    const TriangleMesh mesh = boxMesh({1, 0.8, 0.6}, {100, -40, 7});
    Snapshot snapshot;
    snapshot.origin = {100, -40, 7};
    Numbers numbers;
    for (int i = 0; i < cloud.count; ++i)
    {
        const Eigen::Vector3d place(2 * numbers.next() - 1, 1.6 * numbers.next() - 0.8,
                                    1.2 * numbers.next() - 0.6);
        const double share = numbers.next() * numbers.next();
        addSphere(snapshot, snapshot.origin + cloud.spread * place,
                  cloud.smallest + share * (cloud.largest - cloud.smallest), SphereState::frozen);
    }
    {
        SCOPED_TRACE("OpenGL");
        compare(drawWithOpenGl(mesh, settings, snapshot), settings.size);
    }
    {
        SCOPED_TRACE("tiles");
        compare(drawInTiles(mesh, settings, snapshot), settings.size);
    }
}

TEST(SphereExactness, PerspectiveOutlinesAndDepthsAreThoseOfTheRayCaster)
{
    RenderSettings settings;
    settings.size = {320, 240};
    compare(settings);
}

TEST(SphereExactness, WideAnglesStretchSpheresAsTheyShould)
{
    RenderSettings settings;
    settings.size = {640, 400};
    settings.camera.fieldOfView = 100;
    settings.camera.azimuth = -70;
    compare(settings);
}

TEST(SphereExactness, SpheresOfAMillionAreAsExact)
{
    RenderSettings settings;
    settings.size = {640, 400};
    settings.camera.zoom = 4;
    compare(settings, {700, 0.15, 0.004, 0.012});
}

TEST(SphereExactness, OrthographicOutlinesAndDepthsAreThoseOfTheRayCaster)
{
    RenderSettings settings;
    settings.size = {400, 300};
    settings.camera.orthographic = true;
    settings.camera.elevation = 65;
    compare(settings);
}

TEST(SphereOutline, FourSamplesSmoothTheOutline)
{
    RenderSettings settings;
    settings.backend = test::drawnWith();
    settings.size = {200, 200};
    settings.style.legend = false;
    settings.style.shell = false;
    settings.style.palette.frozen = {0, 0, 0, 255};
    const TriangleMesh mesh = boxMesh({1, 1, 1});
    Snapshot snapshot;
    addSphere(snapshot, {0, 0, 0}, 1, SphereState::frozen);

    // A black disc on white: its area in pixels is the sum of its coverage.
    const auto greys = [&](int samples)
    {
        settings.samples = samples;
        Image image;
        Renderer(mesh, settings).render(snapshot, image);
        std::size_t between = 0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 3)
        {
            between += image.pixels[i] > 110 && image.pixels[i] < 250 ? 1 : 0;
        }
        return between;
    };
    EXPECT_EQ(greys(1), 0U);
    EXPECT_GT(greys(4), 150U);
}

} // namespace
} // namespace frostfill
