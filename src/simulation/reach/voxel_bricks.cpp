// SPDX-License-Identifier: MIT
#include "simulation/reach/voxel_bricks.hpp"

namespace frostfill
{

std::shared_ptr<const VoxelBricks> VoxelBricks::inReach(const GridFrame& frame,
                                                        const InsideTest& inside, std::size_t most)
{
    const std::shared_ptr<VoxelBricks> bricks(new VoxelBricks(frame));
    const auto isTooLarge = [&] { return bricks->words_.size() + kInBrick > most; };
    inside.forEachBoxInReach(
        [&](const Eigen::AlignedBox3d& box)
        {
            if (!isTooLarge())
            {
                bricks->add(frame, box);
            }
        });
    if (isTooLarge())
    {
        return nullptr;
    }
    bricks->link();
    return bricks;
}

void VoxelBricks::add(const GridFrame& frame, const Eigen::AlignedBox3d& box)
{
    const GridPlace low = frame.coordinates(box.min());
    const GridPlace high = frame.coordinates(box.max());
    const GridPlace first = Words::brickOf({low[0] / 64, low[1], low[2]});
    const GridPlace last = Words::brickOf({high[0] / 64, high[1], high[2]});
    for (int z = first[2]; z <= last[2]; ++z)
    {
        for (int y = first[1]; y <= last[1]; ++y)
        {
            for (int x = first[0]; x <= last[0]; ++x)
            {
                words_.obtain(x, y * Words::kSide, z * Words::kSide);
            }
        }
    }
}

void VoxelBricks::link()
{
    const BrickTable& bricks = words_.bricks();
    links_.resize(bricks.size() + 1);
    for (std::size_t brick = 0; brick < bricks.size(); ++brick)
    {
        for (int face = 0; face < 6; ++face)
        {
            GridPlace beside = bricks.place(brick);
            beside[face / 2] += face % 2 == 0 ? -1 : 1;
            const std::uint32_t its = bricks.isInBox(beside)
                                          ? bricks.find(beside[0], beside[1], beside[2])
                                          : BrickTable::kNone;
            links_[brick + 1][face] = its == BrickTable::kNone ? 0 : its + 1;
        }
    }
}

} // namespace frostfill
