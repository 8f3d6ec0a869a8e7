// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace frostfill::testing_support
{

/// A channel of sRGB in 0..1 as linear light.
inline double linear(double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// CIELAB, D65.
inline Eigen::Vector3d lab(const Eigen::Vector3d& rgb)
{
    Eigen::Matrix3d toXyz;
    toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Eigen::Vector3d xyz =
        (toXyz * rgb.cwiseMax(0)).cwiseQuotient(Eigen::Vector3d(0.95047, 1, 1.08883));
    const Eigen::Vector3d f = xyz.unaryExpr(
        [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; });
    return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

/// Complete colour blindness of each kind [Machado, Oliveira & Fernandes 2009, severity 1].
inline std::array<Eigen::Matrix3d, 4> visions()
{
    std::array<Eigen::Matrix3d, 4> result;
    result[0].setIdentity();
    result[1] << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
        1.051998;
    result[2] << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
        0.968881;
    result[3] << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
        0.303900;
    return result;
}

} // namespace frostfill::testing_support
