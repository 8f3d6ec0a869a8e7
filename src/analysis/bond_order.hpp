// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <cstdint>

namespace frostfill
{

/// Sums the spherical harmonics of degree 6 over bonds [Steinhardt et al. 1983]. Those of negative
/// order are as large as those of positive order.
class BondOrder6
{
public:
    /// `direction` has the length 1.
    void add(const Eigen::Vector3d& direction);
    void add(const BondOrder6& other);

    [[nodiscard]] std::uint64_t bonds() const { return bonds_; }
    /// Q6: 1 for bonds along one line, 0 for many in all directions alike, and without bonds.
    [[nodiscard]] double q6() const;

private:
    std::uint64_t bonds_ = 0;
    std::array<std::complex<double>, 7> sums_ = {}; ///< by order, times sqrt(4 pi / 13)
};

} // namespace frostfill
