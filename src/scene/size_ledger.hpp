// SPDX-License-Identifier: MIT
#pragma once

#include "scene/size_curve.hpp"

#include <cstddef>
#include <vector>

namespace frostfill
{

/// The spheres that there are, sieved: what share of their mass and number passes each sieve of a
/// curve, beside what it asks for.
class SizeLedger
{
public:
    explicit SizeLedger(const SizeCurve& curve);

    void add(double radius);
    /// [1] The largest difference of the two cumulative curves by mass at any of the sieves.
    [[nodiscard]] double deviation() const { return largest(masses_, mass_).value; }
    /// The same with one sphere more.
    [[nodiscard]] double deviationWith(double radius) const;
    /// The sieve at which it is.
    [[nodiscard]] std::size_t worst() const { return largest(masses_, mass_).sieve; }

    struct Point
    {
        double asked;
        double achieved;
    };
    [[nodiscard]] Point mass(std::size_t sieve) const;
    [[nodiscard]] Point number(std::size_t sieve) const;
    [[nodiscard]] const std::vector<double>& sieves() const { return sieves_; }

private:
    struct Largest
    {
        double value;
        std::size_t sieve;
    };
    [[nodiscard]] Largest largest(const std::vector<double>& masses, double all) const;
    [[nodiscard]] std::size_t sieveOf(double radius) const;

    std::vector<double> sieves_;
    std::vector<double> askedMass_;   ///< [#sieves_] [1] passing
    std::vector<double> askedNumber_; ///< [#sieves_] [1] passing
    std::vector<double> masses_;      ///< [#sieves_] between a sieve and the one below
    std::vector<double> numbers_;     ///< [#sieves_]
    double mass_ = 0;
    double number_ = 0;
};

} // namespace frostfill
