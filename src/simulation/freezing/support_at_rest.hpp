// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <vector>

namespace frostfill
{

/// Whether spheres at rest are carried: by walls, and by others at rest. One at a time.
class SupportAtRest
{
public:
    explicit SupportAtRest(const World& world) : world_(world) {}

    /// Whether the sphere stays where it is as long as all others do.
    [[nodiscard]] bool carries(std::uint32_t id);
    /// Appends those at rest that touch the sphere: whatever it may carry.
    void findTouching(std::uint32_t id, std::vector<std::uint32_t>& found) const;

    /// Calls wake(id) for unsupported spheres; it lets them run. Spheres that a woken one may have
    /// supported are looked at again, if they are among the ones that may wake: mayWake(id).
    template <class MayWake, class Wake>
    void wakeUncarried(std::vector<std::uint32_t> toLookAt, MayWake&& mayWake, Wake&& wake)
    {
        while (!toLookAt.empty())
        {
            std::vector<std::uint32_t> next;
            for (const std::uint32_t id : toLookAt)
            {
                if (!world_.spheres.isRunning(id) && mayWake(id) && !carries(id))
                {
                    wake(id);
                    findTouching(id, next);
                }
            }
            sortOut(next);
            toLookAt = std::move(next);
        }
    }

private:
    static void sortOut(std::vector<std::uint32_t>& ids);

    const World& world_;
    std::vector<Eigen::Vector3d> normals_; ///< scratch
    std::vector<std::uint32_t> nearby_;    ///< the same
};

} // namespace frostfill
