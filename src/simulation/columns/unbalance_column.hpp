// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/columns/world_columns.hpp"

#include <mutex>
#include <optional>
#include <vector>

namespace frostfill
{

/// What is missing on a sphere at rest, see unbalanceAtRest: found for all of them at once,
/// whenever one is asked for after something has come to rest or woken, or the object has moved.
class UnbalanceColumn final : public WorldColumn
{
public:
    explicit UnbalanceColumn(const World& world) : world_(world) {}

    [[nodiscard]] double value(std::uint32_t id) const override;
    void update() override;
    [[nodiscard]] std::span<const std::uint32_t> changes() const override { return changes_; }

private:
    /// All that the values depend on.
    struct Moment
    {
        std::size_t changes; ///< of spheres' states
        Eigen::Vector3d pull;
        Eigen::Vector3d spin;

        bool operator==(const Moment&) const = default;
    };
    [[nodiscard]] Moment now() const;

    const World& world_;
    mutable std::mutex lock_;             ///< of the next two
    mutable std::optional<Moment> seen_;  ///< when they were found
    mutable std::vector<double> missing_; ///< by row at rest
    std::optional<Moment> toldAt_;        ///< the last update
    std::vector<double> told_;            ///< [#S] the values then
    std::vector<std::uint32_t> changes_;
};

} // namespace frostfill
