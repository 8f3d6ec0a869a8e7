// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/columns/world_columns.hpp"

#include <vector>

namespace frostfill
{

/// The number of contacts at rest, see restingContacts. Until it is first brought up to date it
/// takes no memory and counts whenever it is asked. From then on it keeps what it counted, and
/// counts again where a sphere came to rest or left.
class ContactsColumn final : public WorldColumn
{
public:
    explicit ContactsColumn(const World& world) : world_(world) {}

    [[nodiscard]] double value(std::uint32_t id) const override;
    void update() override;
    [[nodiscard]] std::span<const std::uint32_t> changes() const override { return changes_; }

private:
    void look(std::uint32_t id);
    void addBeside(const Eigen::Vector3d& place);
    void addAgain(std::uint32_t id);

    const World& world_;
    bool keeps_ = false;
    std::size_t seen_ = 0;                ///< of Spheres::changes
    std::vector<Eigen::Vector3d> places_; ///< [#S] where a sphere rests; not finite: nowhere
    std::vector<std::uint32_t> counts_;   ///< [#S]
    std::vector<std::uint32_t> again_;    ///< whose contacts are to be counted, each once
    std::vector<bool> isAgain_;           ///< [#S] those
    std::vector<std::uint32_t> changes_;
};

} // namespace frostfill
