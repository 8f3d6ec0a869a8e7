// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_tree.hpp"

#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <cstdint>
#include <vector>

namespace frostfill
{
namespace
{

TEST(TriangleTree, HasEachTriangleInOneLeafAndInEveryNodeAboveIt)
{
    const TriangleMesh human = builtInMesh("human");
    const TriangleTree tree(human, 8);
    std::vector<int> seen(human.triangles.size(), 0);
    std::size_t place = 0;
    for (std::size_t i = 0; i < tree.nodes().size(); ++i)
    {
        const TriangleTree::Node& node = tree.nodes()[i];
        if (tree.isLeaf(i))
        {
            EXPECT_LE(node.end - node.first, 8U);
            EXPECT_GE(node.end - node.first, 4U);
            EXPECT_EQ(node.first, place);
            place = node.end;
            const auto triangles = tree.triangles(node);
            EXPECT_TRUE(std::is_sorted(triangles.begin(), triangles.end()));
            std::for_each(triangles.begin(), triangles.end(), [&](auto t) { ++seen[t]; });
        }
        else
        {
            const TriangleTree::Node& left = tree.nodes()[i + 1];
            const TriangleTree::Node& right = tree.nodes()[left.skip];
            EXPECT_EQ(left.first, node.first);
            EXPECT_EQ(left.end, right.first);
            EXPECT_EQ(right.end, node.end);
            EXPECT_EQ(right.skip, node.skip);
        }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(seen.size()));
}

TEST(TriangleTree, IsBalancedWhenAllCentroidsAreEqual)
{
    TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    mesh.triangles.assign(1024, {0, 1, 2});
    const TriangleTree tree(mesh, 1);
    EXPECT_EQ(tree.nodes().size(), 2047U);
    for (std::uint32_t i = 0; i < 1024; ++i)
    {
        EXPECT_EQ(tree.order()[i], i);
    }
}

TEST(TriangleTree, IsTheSameWhateverTheThreadsThatMakeIt)
{
    // As many triangles as do not halve evenly.
    const TriangleMesh mesh = shapes::torus(2, 0.5, 173, 61);
    for (const std::uint32_t leafSize : {4U, 7U})
    {
        const TriangleTree expected(mesh, leafSize);
        Threads threads(3);
        const TriangleTree tree(mesh, leafSize, threads);
        ASSERT_EQ(tree.nodes().size(), expected.nodes().size());
        for (std::size_t i = 0; i < tree.nodes().size(); ++i)
        {
            ASSERT_EQ(tree.nodes()[i].first, expected.nodes()[i].first) << i;
            ASSERT_EQ(tree.nodes()[i].end, expected.nodes()[i].end) << i;
            ASSERT_EQ(tree.nodes()[i].skip, expected.nodes()[i].skip) << i;
        }
        EXPECT_TRUE(std::equal(tree.order().begin(), tree.order().end(), expected.order().begin()));
    }
}

TEST(TriangleTree, OfNoTriangleHasNoNode)
{
    EXPECT_TRUE(TriangleTree(TriangleMesh(), 8).nodes().empty());
}

} // namespace
} // namespace frostfill
