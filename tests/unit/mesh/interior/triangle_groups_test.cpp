// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_groups.hpp"

#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace frostfill
{
namespace
{

TEST(TriangleGroups, HaveEachTriangleOnceAndAreAsLongAsAllowed)
{
    const Surface surface(shapes::torus(1, 0.4, 40, 20));
    for (const double longest : {0.0, 0.1, 0.3, 9.0})
    {
        std::vector<std::uint32_t> all;
        std::size_t groups = 0;
        forEachGroup(surface, longest,
                     [&](const TriangleGroup& group)
                     {
                         ++groups;
                         all.insert(all.end(), group.triangles.begin(), group.triangles.end());
                         EXPECT_TRUE(group.triangles.size() == 1 ||
                                     group.box.sizes().maxCoeff() <= longest);
                         for (const std::uint32_t t : group.triangles)
                         {
                             for (const Eigen::Vector3d& corner : surface[t].corner)
                             {
                                 EXPECT_TRUE(group.box.contains(corner));
                             }
                         }
                     });
        const auto order = surface.tree().order();
        EXPECT_TRUE(std::equal(all.begin(), all.end(), order.begin(), order.end()));
        EXPECT_EQ(groups == all.size(), longest < 0.2) << longest;
        EXPECT_TRUE(longest < 9 || groups == all.size() / 16);
    }
}

} // namespace
} // namespace frostfill
