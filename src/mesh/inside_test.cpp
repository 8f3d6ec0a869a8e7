// SPDX-License-Identifier: MIT
#include <mesh/inside_test.hpp>

#include <array>

namespace frostfill
{

InsideTest::InsideTest(const Surface& surface, const TriangleGrid& grid)
    : surface_(&surface), grid_(&grid), sides_(grid.frame().size(), Side::unknown)
{
    for (std::size_t cell = 0; cell < sides_.size(); ++cell)
    {
        if (!grid.cell(cell).empty())
        {
            sides_[cell] = Side::mixed;
        }
    }
    std::vector<std::uint32_t> stack;
    for (std::size_t cell = 0; cell < sides_.size(); ++cell)
    {
        if (sides_[cell] == Side::unknown)
        {
            classifyFrom(cell, stack);
        }
    }
}

// Cells without triangles that share a face are on the same side: one winding number serves all.
void InsideTest::classifyFrom(std::size_t seed, std::vector<std::uint32_t>& stack)
{
    const GridFrame& frame = grid_->frame();
    const auto at = [&](std::size_t cell)
    {
        const int x = static_cast<int>(cell % frame.count[0]);
        const int y = static_cast<int>(cell / frame.count[0] % frame.count[1]);
        const int z = static_cast<int>(cell / frame.count[0] / frame.count[1]);
        return std::array<int, 3>{x, y, z};
    };
    const auto first = at(seed);
    const double winding =
        windingNumber(surface_->mesh(), frame.centre(first[0], first[1], first[2]));
    const Side side = winding > 0.5 ? Side::inside : Side::outside;
    sides_[seed] = side;
    stack.assign(1, static_cast<std::uint32_t>(seed));
    while (!stack.empty())
    {
        const auto here = at(stack.back());
        stack.pop_back();
        for (int face = 0; face < 6; ++face)
        {
            auto next = here;
            next[face / 2] += face % 2 == 0 ? -1 : 1;
            if (next[face / 2] < 0 || next[face / 2] >= frame.count[face / 2])
            {
                continue;
            }
            const std::size_t cell = frame.index(next[0], next[1], next[2]);
            if (sides_[cell] == Side::unknown)
            {
                sides_[cell] = side;
                stack.push_back(static_cast<std::uint32_t>(cell));
            }
        }
    }
}

bool InsideTest::contains(const Eigen::Vector3d& p) const
{
    const std::size_t cell = grid_->frame().index(p);
    if (sides_[cell] != Side::mixed)
    {
        return sides_[cell] == Side::inside;
    }
    // The nearest triangle of the list is the nearest of all when it is within the list's reach.
    const SignedDistance nearest = nearestDistance(*surface_, grid_->cell(cell), p);
    if (std::abs(nearest.value) <= grid_->reach())
    {
        return nearest.value > 0;
    }
    return windingNumber(surface_->mesh(), p) > 0.5;
}

double InsideTest::distance(const Eigen::Vector3d& p) const
{
    const std::size_t cell = grid_->frame().index(p);
    const double reach = grid_->reach();
    if (sides_[cell] != Side::mixed)
    {
        return sides_[cell] == Side::inside ? reach : -reach;
    }
    const double nearest = nearestDistance(*surface_, grid_->cell(cell), p).value;
    if (std::abs(nearest) <= reach)
    {
        return nearest;
    }
    return windingNumber(surface_->mesh(), p) > 0.5 ? reach : -reach;
}

} // namespace frostfill
