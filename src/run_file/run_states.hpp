// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/snapshot.hpp>

#include <cstddef>
#include <cstdint>

namespace frostfill
{

/// A run as its recorder sees it, at one of its states: as it is simulated, or from a tape.
class RunStates
{
public:
    virtual ~RunStates() = default;
    [[nodiscard]] virtual double time() const = 0;            ///< [s] simulated
    [[nodiscard]] virtual std::uint64_t revision() const = 0; ///< grows with each change
    [[nodiscard]] virtual std::size_t sphereCount() const = 0;
    /// Exact where the sphere is at rest.
    [[nodiscard]] virtual SphereRecord sphere(std::size_t id) const = 0;
    /// See Simulation::capture.
    virtual void capture(Snapshot& snapshot) const = 0;
};

} // namespace frostfill
