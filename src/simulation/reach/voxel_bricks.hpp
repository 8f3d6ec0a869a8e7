// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/bricked_cells.hpp"
#include "geometry/grid_frame.hpp"
#include "mesh/interior/inside_test.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace frostfill
{

/// The words that share a face with a word of cubes.
struct WordsBeside
{
    std::size_t left, right;    ///< along the row, x
    std::size_t below, above;   ///< y
    std::size_t before, behind; ///< z
};

/// Numbers the words of a grid of cubes that hold something inside of a surface or within reach of
/// it, brick by brick. All others share the words of brick 0, which stay empty: what is blocked
/// there is blocked already, and nothing floods into them.
class VoxelBricks
{
public:
    using Words = BrickedCells<1>;
    static constexpr std::size_t kInBrick = Words::kInBrick;
    /// What a brick takes besides its cubes [bytes].
    static constexpr std::size_t kBytesOfBrick = 48;

    /// Nothing when there are more words than `most`.
    [[nodiscard]] static std::shared_ptr<const VoxelBricks>
    inReach(const GridFrame& frame, const InsideTest& inside, std::size_t most);

    [[nodiscard]] std::size_t words() const { return links_.size() * kInBrick; }
    /// Word x of row (y, z).
    [[nodiscard]] std::size_t find(int x, int y, int z) const
    {
        return kInBrick + words_.find(x, y, z); // of none: the last one of brick 0
    }
    [[nodiscard]] static bool isNowhere(std::size_t word) { return word < kInBrick; }
    /// Which word of its row, and the row. It may lie beyond the grid.
    [[nodiscard]] GridPlace place(std::size_t word) const { return words_.cell(word - kInBrick); }
    [[nodiscard]] WordsBeside beside(std::size_t word) const
    {
        const std::size_t in = word % kInBrick;
        const std::array<std::uint32_t, 6>& link = links_[word / kInBrick];
        const auto linked = [&](int face, std::size_t its) { return kInBrick * link[face] + its; };
        constexpr std::size_t kY = 1; // from one word of a brick to the next along y, and along z
        constexpr std::size_t kZ = Words::kSide;
        constexpr std::size_t kLast = Words::kSide - 1;
        const std::size_t y = in % kZ;
        const std::size_t z = in / kZ;
        return {linked(0, in),
                linked(1, in),
                y > 0 ? word - kY : linked(2, in + kLast * kY),
                y < kLast ? word + kY : linked(3, in - kLast * kY),
                z > 0 ? word - kZ : linked(4, in + kLast * kZ),
                z < kLast ? word + kZ : linked(5, in - kLast * kZ)};
    }

private:
    explicit VoxelBricks(const GridFrame& frame)
        : words_({frame.count[0] / 64 + 1, frame.count[1], frame.count[2]}, 0)
    {
    }
    void add(const GridFrame& frame, const Eigen::AlignedBox3d& box);
    void link();

    Words words_;
    std::vector<std::array<std::uint32_t, 6>> links_; ///< [#bricks] the bricks beside, by face
};

} // namespace frostfill
