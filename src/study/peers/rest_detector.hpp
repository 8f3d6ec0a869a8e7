// SPDX-License-Identifier: MIT
#pragma once

#include "study/peers/peer.hpp"

#include <limits>
#include <utility>

namespace frostfill
{

/// Tells when spheres have come to rest by the stop rule of all engines.
class RestDetector
{
public:
    /// At the end of each window: whether nearly all have hardly moved in it.
    [[nodiscard]] bool look(std::vector<Eigen::Vector3d> now)
    {
        std::size_t calm = 0;
        last_.resize(now.size(),
                     Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()));
        for (std::size_t k = 0; k < now.size(); ++k)
        {
            calm += (now[k] - last_[k]).squaredNorm() < kPeerStill * kPeerStill ? 1 : 0;
        }
        last_ = std::move(now);
        return static_cast<double>(calm) >= kPeerStillShare * static_cast<double>(last_.size());
    }

private:
    std::vector<Eigen::Vector3d> last_;
};

} // namespace frostfill
