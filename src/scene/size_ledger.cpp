// SPDX-License-Identifier: MIT
#include "scene/size_ledger.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frostfill
{
namespace
{

double passing(const std::vector<double>& amounts, std::size_t sieve, double all)
{
    const auto end = amounts.begin() + static_cast<std::ptrdiff_t>(sieve) + 1;
    return all > 0 ? std::accumulate(amounts.begin(), end, 0.0) / all : 0;
}

} // namespace

SizeLedger::SizeLedger(const SizeCurve& curve)
    : sieves_(curve.sieves()), masses_(sieves_.size()), numbers_(sieves_.size())
{
    for (const double sieve : sieves_)
    {
        askedMass_.push_back(curve.cumulative(sieve, SizeCurve::kMass));
        askedNumber_.push_back(curve.cumulative(sieve, SizeCurve::kNumber));
    }
}

std::size_t SizeLedger::sieveOf(double radius) const
{
    const auto found = std::lower_bound(sieves_.begin(), sieves_.end() - 1, radius);
    return static_cast<std::size_t>(found - sieves_.begin());
}

void SizeLedger::add(double radius)
{
    const std::size_t sieve = sieveOf(radius);
    const double mass = radius * radius * radius;
    masses_[sieve] += mass;
    numbers_[sieve] += 1;
    mass_ += mass;
    number_ += 1;
}

double SizeLedger::deviationWith(double radius) const
{
    std::vector<double> masses = masses_;
    const double mass = radius * radius * radius;
    masses[sieveOf(radius)] += mass;
    return largest(masses, mass_ + mass).value;
}

SizeLedger::Largest SizeLedger::largest(const std::vector<double>& masses, double all) const
{
    Largest found{0, 0};
    double below = 0;
    for (std::size_t k = 0; k < masses.size() && all > 0; ++k)
    {
        below += masses[k];
        const double deviation = std::abs(below / all - askedMass_[k]);
        if (deviation > found.value)
        {
            found = {deviation, k};
        }
    }
    return found;
}

SizeLedger::Point SizeLedger::mass(std::size_t sieve) const
{
    return {askedMass_[sieve], passing(masses_, sieve, mass_)};
}

SizeLedger::Point SizeLedger::number(std::size_t sieve) const
{
    return {askedNumber_[sieve], passing(numbers_, sieve, number_)};
}

} // namespace frostfill
