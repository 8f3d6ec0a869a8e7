// SPDX-License-Identifier: MIT
// Very many spheres are drawn by cells: the same picture as one by one.
#include "render/picture/sphere_draw_list.hpp"
#include "support/drawn_with.hpp"
#include "support/pictures.hpp"

#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace frostfill
{
namespace
{

using testing_support::addSphere;
using testing_support::boxMesh;
using testing_support::Numbers;
using testing_support::smallPicture;

/// In a cube of 2, in no order, of all states but running.
Snapshot heap(std::size_t count)
{
    Snapshot snapshot;
    Numbers numbers;
    const double radius = 0.8 / std::cbrt(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i)
    {
        const Eigen::Vector3d centre(numbers.next(), numbers.next(), numbers.next());
        addSphere(snapshot, (2 - 2 * radius) * centre - Eigen::Vector3d::Constant(1 - radius),
                  radius * (0.6 + 0.4 * numbers.next()),
                  i % 3 == 0 ? SphereState::discarded : SphereState::frozen);
    }
    return snapshot;
}

TEST(SphereCells, HoldEverySphereOnceAndWhole)
{
    Numbers numbers;
    std::vector<SphereInstance> spheres;
    for (int i = 0; i < 20000; ++i)
    {
        // Dense in a corner, and on a plane: cells that are full, and cells of one.
        const auto next = [&] { return static_cast<float>(std::pow(numbers.next(), 4)); };
        spheres.push_back({next(), next(), i % 2 == 0 ? 0 : next(), 0.01F + 0.02F * next(), 1});
    }
    const auto [order, cells] = orderByCells(spheres);
    std::vector<int> times(spheres.size());
    for (const std::uint32_t sphere : order)
    {
        ++times.at(sphere);
    }
    EXPECT_EQ(times, std::vector<int>(spheres.size(), 1));
    std::uint32_t next = 0;
    for (const SphereCell& cell : cells)
    {
        EXPECT_EQ(cell.first, next);
        ASSERT_GT(cell.end, cell.first);
        next = cell.end;
        for (std::uint32_t i = cell.first; i < cell.end; ++i)
        {
            const SphereInstance& own = spheres[order[i]];
            const double way = std::sqrt(std::pow(double{own.x} - cell.around.x, 2) +
                                         std::pow(double{own.y} - cell.around.y, 2) +
                                         std::pow(double{own.z} - cell.around.z, 2));
            EXPECT_LE(way + own.radius, cell.around.radius);
        }
    }
    EXPECT_EQ(next, spheres.size());
}

TEST(SphereCells, GiveThePictureThatOsmesaDraws)
{
    if (!test::openGl())
    {
        GTEST_SKIP() << test::kNoOpenGl;
    }
    const TriangleMesh mesh = boxMesh({2, 2, 2});
    const Snapshot snapshot = heap(kCellsFrom);
    for (const Look look : {Look::clean, Look::studio})
    {
        for (const bool isCut : {false, true})
        {
            RenderSettings settings = smallPicture(look);
            if (isCut)
            {
                settings.style.cutaway = {Cutaway::Kind::plane, {0.3, 0.1, 1}, 0.1, 0, 90};
            }
            Renderer tiles(mesh, settings);
            settings.backend = *test::openGl();
            Renderer osmesa(mesh, settings);
            const ImageDifference difference =
                compareImages(tiles.draw(snapshot), osmesa.draw(snapshot));
            EXPECT_LE(difference.rootMeanSquare, 1) << static_cast<int>(look) << isCut;
        }
    }
}

TEST(SphereCells, ShowNothingElseThanEachSphereForItselfWhateverComes)
{
    const TriangleMesh mesh = boxMesh({2, 2, 2});
    for (const Look look : {Look::clean, Look::studio})
    {
        RenderSettings settings = smallPicture(look);
        Renderer kept(mesh, settings);
        settings.staticLayer = false; // draws all of every cell
        Renderer all(mesh, settings);
        Snapshot snapshot = heap(kCellsFrom);
        Numbers numbers;
        for (int frame = 0; frame < 5; ++frame)
        {
            EXPECT_EQ(compareImages(kept.draw(snapshot), all.draw(snapshot)).largest, 0)
                << "look " << static_cast<int>(look) << ", frame " << frame;
            for (int i = 0; i < 200; ++i)
            {
                const auto which = static_cast<std::size_t>(
                    numbers.next() * static_cast<double>(snapshot.states.size()));
                snapshot.states[which] = SphereState::discarded;
                addSphere(snapshot,
                          2 * Eigen::Vector3d(numbers.next(), numbers.next(), numbers.next()) -
                              Eigen::Vector3d::Constant(1),
                          0.02, i % 10 == 0 ? SphereState::running : SphereState::frozen);
            }
            if (frame == 2)
            {
                settings.camera.azimuth = 77;
                kept.setCamera(settings.camera);
                all.setCamera(settings.camera);
            }
        }
    }
}

} // namespace
} // namespace frostfill
