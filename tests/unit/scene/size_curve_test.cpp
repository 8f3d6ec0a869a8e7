// SPDX-License-Identifier: MIT
#include "scene/radius_distribution.hpp"
#include "scene/read_sizes.hpp"
#include "scene/size_ledger.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

SizeCurve named(const char* text, SharesOf by)
{
    return readSizeCurve({.curve = text, .by = by});
}

double standardNormal(double x)
{
    return std::erfc(-x / std::numbers::sqrt2) / 2;
}

/// Of a lognormal distribution cut at its ends: E[r^p] = exp(p mu + p^2 s^2 / 2) times the share
/// that is between the ends of the distribution moved by p s^2, over that of this one.
struct CutLognormal
{
    double mu, sigma, low, high;

    [[nodiscard]] double between(double shift) const
    {
        return standardNormal((std::log(high) - mu) / sigma - shift) -
               standardNormal((std::log(low) - mu) / sigma - shift);
    }
    [[nodiscard]] double moment(double p) const
    {
        return std::exp(p * mu + p * p * sigma * sigma / 2) * between(p * sigma) / between(0);
    }
};

CutLognormal cutLognormal(double mean, double deviation, double low, double high)
{
    const double variance = std::log1p(std::pow(deviation / mean, 2));
    return {std::log(mean) - variance / 2, std::sqrt(variance), low, high};
}

TEST(SizeCurve, HasTheMomentsOfALognormalDistributionThatIsCut)
{
    const SizeCurve curve = named("lognormal:2,0.8,0.5..5", SharesOf::number);
    const CutLognormal exact = cutLognormal(2, 0.8, 0.5, 5);
    EXPECT_DOUBLE_EQ(curve.smallest(), 0.5);
    EXPECT_DOUBLE_EQ(curve.largest(), 5);
    for (int power = 1; power <= 3; ++power)
    {
        EXPECT_NEAR(curve.meanPower(power) / exact.moment(power), 1, 2e-6) << power;
    }
    // The share of the mass up to r is a lognormal one again, moved by 3 s^2.
    for (const double r : {0.7, 1.0, 2.0, 3.5, 4.9})
    {
        CutLognormal below = exact;
        below.high = r;
        EXPECT_NEAR(curve.cumulative(r, SizeCurve::kNumber), below.between(0) / exact.between(0),
                    2e-6);
        EXPECT_NEAR(curve.cumulative(r, SizeCurve::kMass),
                    below.between(3 * exact.sigma) / exact.between(3 * exact.sigma), 2e-6);
    }
}

TEST(SizeCurve, ConvertsMassToNumberAsThePowersOfALognormalDistributionDo)
{
    const SizeCurve curve = named("lognormal:2,0.8,0.5..5", SharesOf::mass);
    const CutLognormal exact = cutLognormal(2, 0.8, 0.5, 5);
    for (int power = 1; power <= 3; ++power)
    {
        EXPECT_NEAR(curve.meanPower(power) / (exact.moment(power - 3) / exact.moment(-3)), 1, 2e-6);
    }
    const CutLognormal below{exact.mu, exact.sigma, 0.5, 2};
    EXPECT_NEAR(curve.cumulative(2, SizeCurve::kMass), below.between(0) / exact.between(0), 2e-6);
}

TEST(SizeCurve, HasTheMeansOfNormalAndWeibullDistributionsThatAreHardlyCut)
{
    const SizeCurve normal = named("normal:10,1,2..18", SharesOf::number);
    EXPECT_NEAR(normal.meanPower(1), 10, 1e-5);
    EXPECT_NEAR(normal.meanPower(2), 101, 1e-4);
    EXPECT_NEAR(normal.meanPower(3) / 1030, 1, 2e-6); // m^3 + 3 m s^2
    const SizeCurve weibull = named("weibull:2,5,0.1..5", SharesOf::number);
    for (int power = 1; power <= 3; ++power)
    {
        const double exact = std::pow(2, power) * std::tgamma(1 + power / 5.0);
        EXPECT_NEAR(weibull.meanPower(power) / exact, 1, 1e-5) << power;
    }
}

TEST(SizeCurve, IsCutWhereAThousandthLiesBeyondUnlessItsEndsAreGiven)
{
    const SizeCurve weibull = named("weibull:2,5", SharesOf::mass);
    EXPECT_NEAR(std::exp(-std::pow(weibull.largest() / 2, 5)), 0.001, 1e-12);
    EXPECT_NEAR(-std::expm1(-std::pow(weibull.smallest() / 2, 5)), 0.001, 1e-12);
    EXPECT_NEAR(named("normal:10,1", SharesOf::mass).largest(), 13.0902, 1e-4);
}

// A line of the mass from 1 to 10: the number falls with r^-3, so its mean cube is 9 over the
// integral of r^-3, which is (1 - 1/100) / 2.
TEST(SizeCurve, ConvertsALineByMassInClosedForm)
{
    const SizeCurve curve({{1, 10, 1}}, SizeCurve::kMass, {1, 10});
    const double integral = (1 - 1.0 / 100) / 2;
    EXPECT_NEAR(curve.meanPower(3), 9 / integral, 1e-10);
    EXPECT_NEAR(curve.meanPower(2), std::log(10) / integral, 1e-10);
    EXPECT_NEAR(curve.meanPower(1), (1 - 0.1) / integral, 1e-10);
    for (const double r : {1.0, 1.5, 4.0, 9.0, 10.0})
    {
        const double number = (1 - 1 / (r * r)) / 2 / integral;
        EXPECT_NEAR(curve.cumulative(r, SizeCurve::kNumber), number, 1e-12);
        EXPECT_NEAR(curve.cumulative(r, SizeCurve::kMass), (r - 1) / 9, 1e-12);
        EXPECT_NEAR(curve.quantile(number), r, 1e-9);
    }
}

TEST(SizeCurve, TakesSharesOfTheMassOfThreeSizesForNumbersByTheirCubes)
{
    const SizeCurve curve({{1, 1, 0.2}, {4, 4, 0.3}, {16, 16, 0.5}}, SizeCurve::kMass, {1, 4, 16});
    const double sum = 0.2 + 0.3 / 64 + 0.5 / 4096;
    EXPECT_NEAR(curve.cumulative(1, SizeCurve::kNumber), 0.2 / sum, 1e-15);
    EXPECT_NEAR(curve.cumulative(4, SizeCurve::kNumber), (0.2 + 0.3 / 64) / sum, 1e-15);
    EXPECT_NEAR(curve.cumulative(4, SizeCurve::kMass), 0.5, 1e-15);
    EXPECT_NEAR(curve.meanPower(3), 1 / sum, 1e-12);
    EXPECT_EQ(curve.distinct(), (std::vector<double>{1, 4, 16}));
    EXPECT_EQ(curve.quantile(0), 1);
    EXPECT_EQ(curve.quantile(1), 16);
    EXPECT_EQ(curve.in(16).largest(), 1);
    EXPECT_EQ(curve.in(16).smallest(), 1.0 / 16);
}

TEST(SizeCurve, LeavesNothingBetweenPiecesWithAGap)
{
    const SizeCurve curve({{1, 2, 0.5}, {3, 3, 0.25}, {4, 5, 0.25}}, SizeCurve::kNumber, {1, 5});
    EXPECT_EQ(curve.cumulative(2, SizeCurve::kNumber), 0.5);
    EXPECT_EQ(curve.cumulative(2.9, SizeCurve::kNumber), 0.5);
    EXPECT_EQ(curve.cumulative(3, SizeCurve::kNumber), 0.75);
    EXPECT_EQ(curve.quantile(0.6), 3);
    EXPECT_DOUBLE_EQ(curve.quantile(0.875), 4.5);
    EXPECT_EQ(curve.cumulative(0.5, SizeCurve::kMass), 0);
    EXPECT_EQ(curve.cumulative(6, SizeCurve::kMass), 1);
}

TEST(SizeLedger, SievesWhatIsThereBesideWhatIsAskedFor)
{
    const SizeCurve curve({{1, 1, 0.5}, {2, 2, 0.5}}, SizeCurve::kMass, {1, 2});
    SizeLedger ledger(curve);
    EXPECT_EQ(ledger.deviation(), 0); // of nothing
    for (int k = 0; k < 7; ++k)
    {
        ledger.add(1);
    }
    EXPECT_DOUBLE_EQ(ledger.deviation(), 0.5);
    EXPECT_DOUBLE_EQ(ledger.deviationWith(2), 0.5 - 7.0 / 15);
    ledger.add(2);
    EXPECT_DOUBLE_EQ(ledger.deviation(), 0.5 - 7.0 / 15);
    EXPECT_EQ(ledger.worst(), 0U);
    EXPECT_DOUBLE_EQ(ledger.mass(0).achieved, 7.0 / 15);
    EXPECT_DOUBLE_EQ(ledger.number(0).achieved, 7.0 / 8);
    EXPECT_DOUBLE_EQ(ledger.number(0).asked, 8.0 / 9);
    EXPECT_DOUBLE_EQ(ledger.mass(1).achieved, 1);
}

} // namespace
} // namespace frostfill
