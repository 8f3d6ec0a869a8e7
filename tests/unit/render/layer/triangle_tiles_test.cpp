// SPDX-License-Identifier: MIT
#include "render/layer/triangle_tiles.hpp"

#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace frostfill
{
namespace
{

using namespace testing_support;

// The oracle is every triangle. The pictures end within a tile, at its edge and just beyond it.
TEST(TriangleTiles, FindEveryTriangleThatMeetsAPart)
{
    const TriangleMesh mesh = torusMesh(1, 0.4, 48, 12);
    Numbers numbers;
    for (const PictureSize& size : {PictureSize{320, 192}, {161, 97}, {95, 63}})
    {
        RenderSettings settings;
        settings.size = size;
        settings.camera.zoom = 1.5; // some are out of view
        const PictureRegion all = {0, 0, static_cast<double>(size.width),
                                   static_cast<double>(size.height)};
        const Framing framing = frame(mesh.vertices, settings, all);
        std::vector<glm::vec3> positions;
        for (const Eigen::Vector3d& vertex : mesh.vertices)
        {
            positions.emplace_back(framing.toUnit(vertex));
        }
        TriangleTiles tiles(shadeMesh(mesh, positions), framing, size);
        for (int trial = 0; trial < 300; ++trial)
        {
            const int left = static_cast<int>(size.width * numbers.next()) - 10;
            const int bottom = static_cast<int>(size.height * numbers.next()) - 10;
            const int edge = 1 + static_cast<int>(40 * numbers.next());
            const TriangleTiles::Part part = {{left, bottom, left + edge, bottom + edge}, 2};
            tiles.find({&part, 1});
            std::set<std::uint32_t> found(tiles.backs().begin(), tiles.backs().end());
            found.insert(tiles.fronts().begin(), tiles.fronts().end());
            std::set<std::uint32_t> expected;
            for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            {
                if (!tiles.bounds(t).empty() && tiles.bounds(t).overlaps(part.pixels))
                {
                    expected.insert(t);
                }
            }
            ASSERT_EQ(found, expected) << size.width << " wide, part at " << left << "," << bottom;
        }
    }
}

} // namespace
} // namespace frostfill
