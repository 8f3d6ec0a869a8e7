// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_bvh.hpp"

#include "geometry/closest_point.hpp"
#include "mesh/interior/surface.hpp"
#include "mesh/triangle_shape.hpp"

#include <utility>

namespace frostfill
{
namespace
{

/// Triangles, below which a part is not shared among threads any more.
constexpr std::size_t kSmallPart = 1 << 12;

struct Item
{
    Eigen::Vector3d centroid;
    std::uint32_t triangle;
};
using Items = std::span<Item>;

/// Of so many triangles, those in the first half: whole leaves, so that all but one are full.
std::size_t halfOf(std::size_t count, std::size_t leafSize)
{
    return (count / 2 + leafSize - 1) / leafSize * leafSize;
}

/// Splits items at the median centroid along the longest side. Equal centroids are told apart by
/// their number, so the halves depend on no library.
std::array<Items, 2> halve(Items items, std::size_t leafSize)
{
    Eigen::AlignedBox3d box;
    std::for_each(items.begin(), items.end(), [&](const Item& item) { box.extend(item.centroid); });
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = halfOf(items.size(), leafSize);
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle),
                     items.end(),
                     [axis](const Item& a, const Item& b)
                     {
                         const double one = a.centroid[axis];
                         const double other = b.centroid[axis];
                         return one < other || (one == other && a.triangle < b.triangle);
                     });
    return {items.first(middle), items.subspan(middle)};
}

/// Halves again and again, down to leaves, whose triangles ascend. A million take 20 nested calls,
/// however they lie.
void sortAll(Items items, std::size_t leafSize, Threads& threads)
{
    if (items.size() <= leafSize)
    {
        std::sort(items.begin(), items.end(),
                  [](const Item& a, const Item& b) { return a.triangle < b.triangle; });
        return;
    }
    const std::array<Items, 2> halves = halve(items, leafSize);
    const auto sortHalf = [&](std::size_t k) { sortAll(halves[k], leafSize, threads); };
    if (items.size() > kSmallPart)
    {
        threads.forEachLarge(2, sortHalf);
        return;
    }
    sortHalf(0);
    sortHalf(1);
}

/// The triangles of a mesh in the order of a balanced binary tree, whose halves are those of the
/// numbers.
std::vector<std::uint32_t> orderOf(const TriangleMesh& mesh, std::size_t leafSize, Threads& threads)
{
    std::vector<Item> items(mesh.triangles.size());
    threads.forEach(items.size(),
                    [&](std::size_t id)
                    {
                        const auto [a, b, c] = cornersOf(mesh, id);
                        items[id] = {(a + b + c) / 3, static_cast<std::uint32_t>(id)};
                    });
    sortAll(items, leafSize, threads);
    std::vector<std::uint32_t> order(items.size());
    std::transform(items.begin(), items.end(), order.begin(),
                   [](const Item& item) { return item.triangle; });
    return order;
}

} // namespace

/// Takes every second level of the binary tree, so that the last one has the leaves.
class TriangleBvh::Builder
{
public:
    /// Triangles below a child that has a disc. Larger: more time to build. Smaller: more boxes are
    /// looked into near a slanted wall.
    static constexpr std::size_t kMostInDisc = 64;

    Builder(const TriangleMesh& mesh, TriangleBvh& bvh) : mesh_(mesh), bvh_(bvh)
    {
        const Eigen::AlignedBox3d box = boundingBox(mesh);
        const double size = box.sizes().maxCoeff();
        bvh_.centre_ = box.center();
        bvh_.scale_ = size > 0 ? 1 / size : 1;
        bvh_.starts_.push_back(0);
        const std::size_t leaves = bvh_.order_.size() / kInLeaf + 1;
        bvh_.nodes_.reserve(leaves / 2); // most have more than two
        bvh_.leaves_.reserve(leaves);
        bvh_.starts_.reserve(leaves + 1);
        build(bvh_.order_, true);
    }

private:
    using Triangles = std::span<const std::uint32_t>;
    static bool isLeaf(Triangles triangles) { return triangles.size() <= kInLeaf; }

    /// Calls visit(child) with the triangles of each child of a node.
    template <class Visit>
    static void forEachChild(Triangles triangles, bool isRoot, Visit&& visit)
    {
        if (isLeaf(triangles))
        {
            visit(triangles);
            return;
        }
        std::size_t levels = 0; // down to the farthest leaf; to others there may be one less
        for (std::size_t size = triangles.size(); size > kInLeaf; ++levels)
        {
            size = std::max(halfOf(size, kInLeaf), size - halfOf(size, kInLeaf));
        }
        const auto forEachHalf = [](Triangles all, auto&& visitHalf)
        {
            visitHalf(all.first(halfOf(all.size(), kInLeaf)));
            visitHalf(all.subspan(halfOf(all.size(), kInLeaf)));
        };
        const bool oneLevel = isRoot && levels % 2 == 1;
        forEachHalf(triangles, [&](Triangles half)
                    { oneLevel || isLeaf(half) ? visit(half) : forEachHalf(half, visit); });
    }

    /// Returns the box around all below the node.
    Eigen::AlignedBox3d build(Triangles triangles, bool isRoot)
    {
        const std::size_t number = bvh_.nodes_.size();
        bvh_.nodes_.emplace_back(); // and its children behind it, which may move it
        Node built{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            built.low[axis] = Four{} + std::numeric_limits<float>::infinity();
            built.high[axis] = Four{} - std::numeric_limits<float>::infinity();
        }
        std::size_t count = 0;
        Eigen::AlignedBox3d all;
        const auto take = [&](Triangles below)
        {
            enterDisc(built, count, below);
            Eigen::AlignedBox3d around;
            if (isLeaf(below))
            {
                built.child[count] = {static_cast<std::uint32_t>(bvh_.leaves_.size()),
                                      static_cast<std::uint32_t>(below.size())};
                around = addLeaf(below);
            }
            else
            {
                built.child[count] = {static_cast<std::uint32_t>(bvh_.nodes_.size()), 0};
                around = build(below, false);
            }
            const Box box = bvh_.around(around);
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                built.low[axis][count] = box.low[axis][0];
                built.high[axis][count] = box.high[axis][0];
            }
            all.extend(around);
            ++count;
        };
        forEachChild(triangles, isRoot, take);
        bvh_.nodes_[number] = built;
        return all;
    }

    /// Leaves come in the order of their triangles. Returns the box around it.
    Eigen::AlignedBox3d addLeaf(Triangles triangles)
    {
        Eigen::AlignedBox3d box;
        Discs discs{};
        for (std::size_t k = 0; k < triangles.size(); ++k)
        {
            const auto corners = cornersOf(mesh_, triangles[k]);
            enter(discs, k, boundOf(corners));
            box.extend(corners[0]).extend(corners[1]).extend(corners[2]);
        }
        bvh_.leaves_.push_back(discs);
        bvh_.starts_.push_back(bvh_.starts_.back() + static_cast<std::uint32_t>(triangles.size()));
        return box;
    }

    /// Makes a disc the k-th, in the frame of the nodes.
    void enter(Discs& discs, std::size_t k, const TriangleBound& disc) const
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const auto at = static_cast<Eigen::Index>(axis);
            discs.normal[axis][k] = static_cast<float>(disc.normal[at]);
            discs.centre[axis][k] =
                static_cast<float>((disc.centre[at] - bvh_.centre_[at]) * bvh_.scale_);
        }
        discs.offset[k] =
            static_cast<float>((disc.offset - disc.normal.dot(bvh_.centre_)) * bvh_.scale_);
        discs.radius[k] = grown(disc.radius);
    }
    [[nodiscard]] float grown(double length) const
    {
        return static_cast<float>(length * bvh_.scale_ * (1 + kRounding) + kGrow);
    }

    /// The disc, with its thickness, around all triangles of a node.
    void enterDisc(Node& built, std::size_t k, std::span<const std::uint32_t> triangles) const
    {
        if (triangles.size() > kMostInDisc)
        {
            built.discs.radius[k] = static_cast<float>(kFarthest);
            return;
        }
        built.hasDiscs = true;
        TriangleBound disc;
        disc.normal.setZero();
        disc.centre.setZero();
        const auto forEach = [&](auto&& visit)
        {
            for (const std::uint32_t triangle : triangles)
            {
                visit(cornersOf(mesh_, triangle));
            }
        };
        forEach(
            [&](const std::array<Eigen::Vector3d, 3>& corner)
            {
                const auto& [a, b, c] = corner;
                disc.normal += (c - a).cross(b - a);
                disc.centre += (a + b + c) / 3;
            });
        disc.normal.normalize();
        disc.centre /= static_cast<double>(triangles.size());
        disc.offset = disc.normal.dot(disc.centre);
        double thickness = 0;
        forEach(
            [&](const std::array<Eigen::Vector3d, 3>& corner)
            {
                for (const Eigen::Vector3d& p : corner)
                {
                    disc.radius = std::max(disc.radius, (p - disc.centre).norm());
                    thickness = std::max(thickness, disc.toPlane(p));
                }
            });
        enter(built.discs, k, disc);
        built.thickness[k] = grown(thickness);
    }

    const TriangleMesh& mesh_;
    TriangleBvh& bvh_;
};

TriangleBvh::TriangleBvh(const TriangleMesh& mesh)
{
    Threads one(1);
    *this = TriangleBvh(mesh, one);
}

TriangleBvh::TriangleBvh(const TriangleMesh& mesh, Threads& threads)
    : order_(orderOf(mesh, kInLeaf, threads))
{
    if (!order_.empty())
    {
        Builder(mesh, *this);
    }
}

void TriangleBvh::move(const Eigen::Vector3d& origin, double length, const std::array<int, 3>& axis)
{
    const auto permute = [&](auto& along)
    {
        const auto before = along;
        for (std::size_t k = 0; k < 3; ++k)
        {
            along[k] = before[static_cast<std::size_t>(axis[k])];
        }
    };
    const auto permuteDiscs = [&](Discs& discs)
    {
        permute(discs.normal);
        permute(discs.centre);
    };
    centre_ = (centre_ - origin) / length;
    permute(centre_);
    scale_ *= length;
    for (Node& node : nodes_)
    {
        permute(node.low);
        permute(node.high);
        permuteDiscs(node.discs);
    }
    std::for_each(leaves_.begin(), leaves_.end(), permuteDiscs);
}

void TriangleBvh::findNear(const Eigen::Vector3d& p, double distance,
                           std::vector<std::uint32_t>& found) const
{
    found.clear();
    forEachTriangleNear(p, distance,
                        [&](std::uint32_t triangle)
                        {
                            found.push_back(triangle);
                            return distance;
                        });
    std::sort(found.begin(), found.end());
}

std::optional<NearestPoint> nearestPoint(const TriangleMesh& mesh, const TriangleBvh& bvh,
                                         const Eigen::Vector3d& p, double within)
{
    std::optional<NearestPoint> found;
    double least = within * within;
    const auto visit = [&](std::uint32_t triangle)
    {
        const auto [a, b, c] = cornersOf(mesh, triangle);
        const Eigen::Vector3d point = closestPointOnTriangle(p, a, b, c).point;
        const double square = (point - p).squaredNorm();
        if (square < least || (found && square == least && triangle < found->triangle))
        {
            least = square;
            found = {point, triangle, std::sqrt(square)};
        }
        return std::sqrt(least);
    };
    bvh.forEachTriangleNear(p, within, visit);
    return found;
}

} // namespace frostfill
