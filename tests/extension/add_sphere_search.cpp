// SPDX-License-Identifier: MIT
#include "simulation/paper/sphere_search.hpp"

#include <cmath>
#include <vector>

namespace frostfill
{
namespace
{

/// The spheres at rest at the height of the running one.
class Layer final : public SphereSearchPart
{
public:
    [[nodiscard]] std::span<const IdRange> near(const Spheres& spheres, std::uint32_t i,
                                                IdRange frozen) override
    {
        constexpr double kReach = 3; // two radii, and what the sphere may be pushed [r]
        const double y = spheres.running().position[i].y();
        found_.clear();
        for (std::size_t id = frozen.begin; id < frozen.end; ++id)
        {
            if (std::abs(spheres.position(id).y() - y) < kReach)
            {
                found_.push_back({id, id + 1});
            }
        }
        return found_;
    }

private:
    std::vector<IdRange> found_;
};

[[maybe_unused]] const SphereSearch kLayer =
    sphereSearches().add("layer", [](const SphereGrid&) { return std::make_unique<Layer>(); });

} // namespace
} // namespace frostfill
