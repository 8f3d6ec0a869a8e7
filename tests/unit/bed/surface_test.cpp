// SPDX-License-Identifier: MIT
#include "mesh/interior/walls.hpp"
#include "support/expect_error.hpp"
#include "unit/bed/bed_on_the_spot.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <utility>

namespace frostfill
{
namespace
{

using test::bedOf;
using test::expectError;

BedSettings treatment(const std::string& text, std::size_t resolution = 4)
{
    BedSettings settings;
    settings.resolution = resolution;
    parseContacts(text, settings);
    return settings;
}

std::size_t crossings(const TriangleMesh& mesh)
{
    return findCrossings(mesh, MeshIndex(mesh, 2)).count;
}

/// Closed, oriented, free of crossings, and of the volume that it says.
void expectSound(const BedSurface& surface)
{
    const TriangleMesh mesh = test::welded(surface);
    EXPECT_EQ(mesh.triangles.size(), surface.triangles());
    EXPECT_EQ(test::openEdges(mesh), 0U);
    EXPECT_EQ(crossings(mesh), 0U);
    EXPECT_NEAR(signedVolume(mesh) / surface.freeVolume(), 1, 1e-9);
}

class SurfaceOfTreatment : public ::testing::TestWithParam<const char*>
{
};

TEST_P(SurfaceOfTreatment, IsClosedAndNowhereCrossesItselfInACrystal)
{
    const test::Spheres spheres = test::crystal(2);
    for (const std::size_t resolution : {1, 2, 4, 7})
    {
        SCOPED_TRACE(resolution);
        const Bed bed = bedOf(test::crystalBox(2), spheres, treatment(GetParam(), resolution));
        expectSound(BedSurface(bed));
    }
}

TEST_P(SurfaceOfTreatment, IsClosedAndNowhereCrossesItselfWithSpheresOfAllSizes)
{
    const test::Spheres spheres = test::touchingSpheres(400, 0.3, 10);
    ASSERT_EQ(spheres.radii.size(), 400U);
    const Bed bed = bedOf(shapes::box({-1, -1, -1}, {1, 1, 1}, 3), spheres, treatment(GetParam()));
    const BedSurface surface(bed);
    EXPECT_EQ(surface.links().links.empty(), std::string(GetParam()).starts_with("shrink"));
    expectSound(surface);
}

INSTANTIATE_TEST_SUITE_P(All, SurfaceOfTreatment,
                         ::testing::Values("shrink:0.99", "caps:0.02", "caps:0.1"));

// The triangles of inscribed spheres tend to spheres as 1 / N^2.
TEST(BedSurface, HasThePorosityOfShrunkSpheresAsTheyGetFiner)
{
    const test::Spheres spheres = test::crystal(1);
    double before = 0;
    for (const std::size_t resolution : {5, 10, 20})
    {
        const Bed bed = bedOf(test::crystalBox(1), spheres, treatment("shrink:0.95", resolution));
        const double exact = 1 - 0.95 * 0.95 * 0.95 * (1 - bed.porosity());
        const double error = BedSurface(bed).porosity() - exact;
        EXPECT_GT(error, 0);
        EXPECT_LT(error, 0.9 / static_cast<double>(resolution * resolution));
        if (before > 0)
        {
            EXPECT_NEAR(before / error, 4, 0.1);
        }
        before = error;
    }
}

class CapsBesideWalls : public ::testing::TestWithParam<int>
{
protected:
    [[nodiscard]] static TriangleMesh container()
    {
        switch (GetParam())
        {
        case 0:
            return shapes::box({-1, -1, -1}, {1, 1, 1}, 1);
        case 1:
            return shapes::box({-1, -1, -1}, {1, 1, 1}, 40);
        case 2:
            return shapes::cylinder(1, 2, 64);
        case 3:
            return shapes::cylinder(1, 2, 7);
        case 4:
            return shapes::torus();
        default:
            return shapes::torus(1, 0.4, 96, 48);
        }
    }
};

TEST_P(CapsBesideWalls, LeaveTheSurfaceClosedAndNowhereCrossingItself)
{
    const TriangleMesh mesh = container();
    const test::Spheres spheres = test::touchingSpheresIn(mesh, 250, 0.16);
    for (const char* how : {"caps:0.02", "caps:0.005", "caps:0.05"})
    {
        SCOPED_TRACE(how);
        const Bed bed = bedOf(mesh, spheres, treatment(how));
        const BedSurface surface(bed);
        const std::vector<BedLink>& links = surface.links().links;
        const auto walls =
            std::count_if(links.begin(), links.end(),
                          [](const BedLink& link) { return link.second == BedLink::kWall; });
        EXPECT_GT(walls, 25);
        EXPECT_GT(links.size(), 50U);
        expectSound(surface);
    }
}

INSTANTIATE_TEST_SUITE_P(Containers, CapsBesideWalls, ::testing::Range(0, 6));

TEST(BedSurface, FlattensSpheresUpToTheGap)
{
    const test::Spheres two = {{{-1, 0, 0}, {1, 0, 0}}, {1, 1}};
    const Bed bed = bedOf(shapes::box({-2, -3, -3}, {3, 3, 3}), two, treatment("caps:0.1"));
    const BedSurface surface(bed);
    EXPECT_EQ(surface.links().links.size(), 2U); // the other sphere, and the wall at -2
    double left = -9;
    double right = 9;
    double lowest = 9;
    for (const Eigen::Vector3d& p : test::welded(surface).vertices)
    {
        if (std::abs(p.y()) < 2)
        {
            left = p.x() < 0 ? std::max(left, p.x()) : left;
            right = p.x() > 0 && p.x() < 2.5 ? std::min(right, p.x()) : right;
            lowest = std::min(lowest, p.x());
        }
    }
    EXPECT_NEAR(right - left, 0.1, 1e-6);
    EXPECT_NEAR(lowest, -1.9, 1e-6);
    expectSound(surface);
}

TEST(BedSurface, HasTheSamePartsForAnyNumberOfThreads)
{
    const test::Spheres spheres = test::touchingSpheres(300, 0.3, 5);
    std::vector<StlTriangle> first;
    for (const int threads : {1, 2, 5})
    {
        BedSettings settings = treatment("caps:0.05");
        settings.threads = threads;
        const Bed bed = bedOf(shapes::box({-1, -1, -1}, {1, 1, 1}), spheres, settings);
        const BedSurface surface(bed);
        std::vector<StlTriangle> all;
        surface.forEachPart(bed.patches().size() - 1, [&](std::span<const StlTriangle> part)
                            { all.insert(all.end(), part.begin(), part.end()); });
        first = first.empty() ? all : first;
        EXPECT_TRUE(all == first);
    }
}

/// Names of the patches of a bed, each with its kind and its number of triangles.
std::string patchesOf(const BedContainer& container)
{
    const Bed bed(container, {{1, 0, 0}}, {0.2}, Eigen::Vector3d::UnitY(), {});
    const BedSurface surface(bed);
    std::string text;
    for (std::size_t k = 0; k + 1 < bed.patches().size(); ++k)
    {
        const BedPatch& patch = bed.patches()[k];
        text +=
            fmt::format("{}:{}:{} ", patch.name, kPatchNames[static_cast<std::size_t>(patch.kind)],
                        surface.triangles(k));
    }
    return text;
}

TEST(BedSurface, KnowsTheFlatEndsOfATubeAndNoneOfATorus)
{
    const TriangleMesh box = shapes::box({-2, -2, -2}, {2, 2, 2}, 2);
    EXPECT_EQ(patchesOf({box}), "inlet:inlet:8 outlet:outlet:8 wall:wall:32 ");
    const TriangleMesh torus = shapes::torus();
    EXPECT_EQ(patchesOf({torus}), fmt::format("wall:wall:{} ", torus.triangles.size()));
}

TEST(BedSurface, HasThePatchesOfItsParts)
{
    const TriangleMesh box = shapes::box({-2, -2, -2}, {2, 2, 2}, 2);
    enum Side
    {
        foot,
        top,
        left,
        others
    };
    const auto partsOf = [&](std::array<std::uint32_t, 4> part, std::vector<std::string> names)
    {
        BedContainer container{box, std::move(names)};
        for (const auto& triangle : box.triangles)
        {
            Eigen::AlignedBox3d around;
            for (const std::uint32_t corner : triangle)
            {
                around.extend(box.vertices[corner]);
            }
            container.partOf.push_back(part[around.max().y() == -2   ? foot
                                            : around.min().y() == 2  ? top
                                            : around.max().x() == -2 ? left
                                                                     : others]);
        }
        return patchesOf(container);
    };
    constexpr std::uint32_t kNone = BedContainer::kNoPart;
    EXPECT_EQ(partsOf({0, 1, 2, 2}, {"sieve", "lid", "glass"}),
              "sieve:inlet:8 lid:outlet:8 glass:wall:32 ");
    // Of what is more than an end, and of lids, the ends have names of their own.
    EXPECT_EQ(partsOf({0, kNone, 0, 0}, {"cup"}), "inlet:inlet:8 outlet:outlet:8 cup:wall:32 ");
    EXPECT_EQ(partsOf({0, 1, 1, 1}, {"foot", "wall"}),
              "foot:inlet:8 outlet:outlet:8 wall:wall:32 ");
    EXPECT_EQ(partsOf({0, 0, 1, 0}, {"box", "inlet"}),
              "inlet:inlet:8 outlet:outlet:8 box:wall:32 ");
    EXPECT_EQ(partsOf({0, 1, 2, 2}, {"wall", "lid", "side"}),
              "inlet:inlet:8 lid:outlet:8 side:wall:32 ");
}

TEST(BedSurface, RefusesWhatNoTreatmentParts)
{
    const TriangleMesh cube = shapes::box({-1, -1, -1}, {1, 1, 1});
    const auto make = [&](const test::Spheres& spheres, const char* how)
    {
        const Bed bed = bedOf(cube, spheres, treatment(how));
        const BedSurface surface(bed);
    };
    const test::Spheres crossing = {{{0, 0, 0}, {0.3, 0, 0}}, {0.2, 0.2}};
    expectError(
        ErrorCode::badData, [&] { make(crossing, "shrink:0.99"); }, "sphere 0",
        "overlaps sphere 1");
    EXPECT_NO_THROW(make(crossing, "shrink:0.7"));
    EXPECT_NO_THROW(make(crossing, "caps"));
    expectError(
        ErrorCode::badData,
        [&] {
            make({{{0, 2, 0}}, {0.1}}, "shrink");
        },
        "outside the container");
    expectError(
        ErrorCode::badData,
        [&] {
            make({{{0, 0.95, 0}}, {0.1}}, "shrink");
        },
        "passes through the wall");
    expectError(
        ErrorCode::badData,
        [&] {
            make({{{0, 0.95, 0}}, {0.2}}, "caps");
        },
        "nothing is left");
    expectError(
        ErrorCode::badData,
        [&] {
            make({{{0, 0, 0}, {0, 0, 0}}, {0.2, 0.2}}, "caps");
        },
        "sphere 0", "centre of sphere 1");
}

TEST(BedSettings, AreRefusedWhereTheyMakeNoSense)
{
    BedSettings settings;
    constexpr const char* kUnknown = "there is no treatment of contacts";
    constexpr const char* kMalformed = "write none, shrink:FACTOR or caps:GAP";
    constexpr const char* kFactor = "a factor above 0 and below 1";
    constexpr const char* kGap = "gap of caps must be from 0.0001 to 0.2 radii";
    for (const auto& [text, says] : {std::pair("shrinks", kUnknown),
                                     {"", kUnknown},
                                     {"shrink:", kMalformed},
                                     {"shrink:0.9,1", kMalformed},
                                     {"none:1", kMalformed},
                                     {"caps:x", kMalformed},
                                     {"caps:0.02 ", kMalformed},
                                     {"bridges:0.2", kUnknown},
                                     {"shrink:1", kFactor},
                                     {"shrink:0", kFactor},
                                     {"shrink:-1", kFactor},
                                     {"shrink:nan", kFactor},
                                     {"caps:0", kGap},
                                     {"caps:0.5", kGap}})
    {
        SCOPED_TRACE(text);
        expectError(
            ErrorCode::usage, [&, text = text] { parseContacts(text, settings); }, says);
    }
    const auto refused = [](const BedSettings& wrong, const char* says)
    {
        expectError(
            ErrorCode::usage, [&] { checkBedSettings(wrong); }, says);
    };
    refused({.resolution = 0}, "resolution");
    refused({.resolution = 101}, "resolution");
    refused({.voxels = 1}, "voxels");
    refused({.voxels = 4097}, "voxels");
    refused({.cell = 0}, "cell");
    refused({.cell = std::nan("")}, "cell");
    refused({.threads = -1}, "threads");
    parseContacts("caps:0.05", settings);
    EXPECT_EQ(settings.contacts, ContactTreatment::caps);
    EXPECT_EQ(settings.gap, 0.05);
}

} // namespace
} // namespace frostfill
