// SPDX-License-Identifier: MIT
#pragma once

#include <simulation/descent.hpp>
#include <simulation/fall_index.hpp>
#include <simulation/open_sites.hpp>
#include <simulation/set_clock.hpp>
#include <simulation/world.hpp>

#include <optional>
#include <vector>

namespace frostfill
{

/// Instant fill: spheres rain one by one from the object's ceilings and come down without dynamics,
/// each to a place that carries it. Once nothing can be released at a ceiling, every other place
/// that is still free is used, so that "full" means that no place is left.
class DescentEngine : public Engine
{
public:
    explicit DescentEngine(World& world);
    bool step() override;

private:
    bool placeOne();
    [[nodiscard]] std::optional<Eigen::Vector3d> nextRelease();
    [[nodiscard]] std::optional<Eigen::Vector3d> releaseAtCeiling();
    [[nodiscard]] std::optional<Eigen::Vector3d> releaseAnywhere();
    void findCeilings();

    World& world_;
    FallIndex falls_;
    OpenSites sites_;
    Descent descent_;
    SetClock clock_;
    std::vector<std::uint32_t> ceilings_; ///< open sites with none above
    std::size_t sweep_ = 0;               ///< where releaseAnywhere goes on
    std::uint64_t draws_ = 0;
    std::size_t setSize_ = 1;
};

} // namespace frostfill
