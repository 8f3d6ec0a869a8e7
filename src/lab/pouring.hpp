// SPDX-License-Identifier: MIT
#pragma once

#include "lab/program_peer.hpp"

#include <cstdint>
#include <vector>

namespace frostfill
{

/// Where spheres appear next: sites of a loose lattice under the top of a box-shaped object, each
/// shifted a little anew every time, as long as they are clear of all that is there.
class Pouring
{
public:
    explicit Pouring(const PeerTask& task);

    /// At most as many as are missing; `present` are the centres of all spheres so far.
    [[nodiscard]] std::vector<Eigen::Vector3d> next(const std::vector<Eigen::Vector3d>& present);

private:
    std::vector<Eigen::Vector3d> sites_;
    std::size_t count_;
    double band_; ///< height above which a sphere can be in the way
    std::uint64_t times_ = 0;
};

/// The built-in cube in units of the radius at which so many spheres take that share of it.
[[nodiscard]] TriangleMesh cubeFilledTo(double share, std::uint64_t count);

} // namespace frostfill
