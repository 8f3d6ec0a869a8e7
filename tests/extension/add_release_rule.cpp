// SPDX-License-Identifier: MIT
#include "simulation/contact/depenetration.hpp"
#include "simulation/release/release_rule.hpp"

namespace frostfill
{
namespace
{

/// Spheres appear on the vertical line through the middle of the object's box, the highest first.
class CentreLine final : public ReleasePart
{
public:
    explicit CentreLine(const World& world) : world_(world) {}

    [[nodiscard]] std::optional<PlacedSphere> next(const ReleaseQuery& query) override
    {
        const double radius = world_.radii.largest();
        const auto found = place(radius, query);
        return found ? std::optional<PlacedSphere>({*found, radius}) : std::nullopt;
    }
    [[nodiscard]] std::optional<Eigen::Vector3d> place(double radius,
                                                       const ReleaseQuery& query) override
    {
        constexpr double kStep = 0.25;     // between two places that are tried [r]
        constexpr double kFarthest = 0.01; // that a place may be moved out of an overlap [r]
        const Eigen::AlignedBox3d& box = world_.surface.box();
        for (double y = box.max().y(); y > box.min().y(); y -= kStep)
        {
            Eigen::Vector3d p(box.center().x(), y, box.center().z());
            if (world_.inside.contains(p) && depenetrate(world_, p, radius, kFarthest))
            {
                Footprint seen; // for rules that look ahead
                if ((!query.prepare || query.prepare(p, radius, seen)) && query.suits(p, radius))
                {
                    return p;
                }
            }
        }
        return std::nullopt;
    }
    [[nodiscard]] bool any() override
    {
        const auto anywhere = [](const Eigen::Vector3d&, double) { return true; };
        return place(world_.radii.smallest(), {.suits = anywhere}).has_value();
    }
    void close(const Eigen::Vector3d& /*centre*/, double /*radius*/) override {}

private:
    const World& world_;
};

[[maybe_unused]] const ReleaseRule kColumn =
    releaseRules().add("column", [](const World& world, double /*band*/, Threads& /*threads*/)
                       { return std::make_unique<CentreLine>(world); });

} // namespace
} // namespace frostfill
