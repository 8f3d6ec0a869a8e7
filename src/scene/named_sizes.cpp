// SPDX-License-Identifier: MIT
#include "base/read_number.hpp"
#include "scene/read_sizes.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

/// Pieces into which a formula is cut. [1] Larger: memory, and time for each draw. Smaller: moments
/// and curves that are off by more than 1e-6.
constexpr std::size_t kPieces = 2000;
/// Steps at which the achieved curve is compared.
constexpr std::size_t kSteps = 32;
/// Share beyond either end, where none are given.
constexpr double kCut = 0.001;
constexpr double kQuantileOfCut = 3.090232306167813; ///< of the standard normal distribution
constexpr double kSmallestShare = 1e-9;              ///< between ends that can be meant

struct Formula
{
    std::function<double(double)> below; ///< share below a radius
    double low;                          ///< of the usual ends
    double high;
};

double normalShare(double x)
{
    return std::erfc(-x / std::numbers::sqrt2) / 2;
}

Formula lognormal(double mean, double deviation)
{
    const double variance = std::log1p(std::pow(deviation / mean, 2));
    const double sigma = std::sqrt(variance);
    const double mu = std::log(mean) - variance / 2;
    return {[=](double r) { return normalShare((std::log(r) - mu) / sigma); },
            std::exp(mu - kQuantileOfCut * sigma), std::exp(mu + kQuantileOfCut * sigma)};
}

Formula normal(double mean, double deviation)
{
    return {[=](double r) { return normalShare((r - mean) / deviation); },
            mean - kQuantileOfCut * deviation, mean + kQuantileOfCut * deviation};
}

Formula weibull(double scale, double shape)
{
    return {[=](double r) { return -std::expm1(-std::pow(r / scale, shape)); },
            scale * std::pow(-std::log1p(-kCut), 1 / shape),
            scale * std::pow(-std::log(kCut), 1 / shape)};
}

struct Named
{
    std::string_view name;
    const char* form;
    Formula (*make)(double, double);
};
constexpr std::array<Named, 3> kNamed = {{{"lognormal", "lognormal:MEAN,SD", lognormal},
                                          {"normal", "normal:MEAN,SD", normal},
                                          {"weibull", "weibull:SCALE,SHAPE", weibull}}};

[[noreturn]] void refuse(std::string_view text, const std::string& why)
{
    throw Error(ErrorCode::usage, fmt::format("spheres.sizes (--sizes) is '{}': {}", text, why));
}

double numberOf(std::string_view item, std::string_view whole, const char* form)
{
    const auto value = readNumber<double>(item);
    if (!value || !std::isfinite(*value) || *value <= 0)
    {
        refuse(whole, fmt::format("'{}' must be a number above 0, as in {} or {},LOW..HIGH", item,
                                  form, form));
    }
    return *value;
}

/// The text up to the separator, which goes with it.
std::string_view take(std::string_view& rest, std::string_view separator)
{
    const std::size_t end = std::min(rest.find(separator), rest.size());
    const std::string_view item = rest.substr(0, end);
    rest.remove_prefix(std::min(rest.size(), end + separator.size()));
    return item;
}

/// Its ends are those that are stated, or the usual ones.
Formula readFormula(std::string_view text)
{
    const std::string_view name = text.substr(0, text.find(':'));
    for (const Named& named : kNamed)
    {
        if (named.name != name)
        {
            continue;
        }
        std::string_view rest = text.substr(name.size() + 1);
        const double first = numberOf(take(rest, ","), text, named.form);
        const double second = numberOf(take(rest, ","), text, named.form);
        Formula formula = named.make(first, second);
        if (!rest.empty())
        {
            formula.low = numberOf(take(rest, ".."), text, named.form);
            formula.high = numberOf(rest, text, named.form);
        }
        if (!(formula.low > 0))
        {
            refuse(text, fmt::format("it reaches radii below 0; give its ends, as in {},LOW..HIGH",
                                     named.form));
        }
        if (!(formula.low < formula.high))
        {
            refuse(text, fmt::format("its ends must be two, the smaller one first, as in "
                                     "{},LOW..HIGH",
                                     named.form));
        }
        return formula;
    }
    refuse(text, fmt::format("there is no distribution '{}'; there are lognormal:MEAN,SD, "
                             "normal:MEAN,SD and weibull:SCALE,SHAPE",
                             name));
}

} // namespace

bool isNamedSizes(std::string_view text)
{
    const std::size_t colon = text.find(':');
    return colon != std::string_view::npos && colon > 1 && // a drive has one letter
           text.substr(0, colon).find_first_of("./\\") == std::string_view::npos;
}

SizeCurve namedSizes(std::string_view text, int power)
{
    const Formula formula = readFormula(text);
    const double ratio = formula.high / formula.low;
    if (!(ratio <= kLargestSizeRatio))
    {
        refuse(text, fmt::format("it reaches from {:.4g} to {:.4g}; sizes may differ by a factor "
                                 "of at most {}; give its ends, as in ,LOW..HIGH",
                                 formula.low, formula.high, kLargestSizeRatio));
    }
    const auto at = [&](std::size_t k, std::size_t of)
    {
        return k == of ? formula.high
                       : formula.low *
                             std::pow(ratio, static_cast<double>(k) / static_cast<double>(of));
    };
    std::vector<SizeCurve::Piece> pieces;
    double sum = 0;
    for (std::size_t k = 0; k < kPieces; ++k)
    {
        const double low = at(k, kPieces);
        const double high = at(k + 1, kPieces);
        const double share = formula.below(high) - formula.below(low);
        if (share > 0)
        {
            pieces.push_back({low, high, share});
            sum += share;
        }
    }
    if (!(sum > kSmallestShare))
    {
        refuse(text, fmt::format("next to nothing of it is between {:.4g} and {:.4g}", formula.low,
                                 formula.high));
    }
    for (SizeCurve::Piece& piece : pieces)
    {
        piece.share /= sum;
    }
    std::vector<double> sieves;
    for (std::size_t k = 0; k <= kSteps; ++k)
    {
        sieves.push_back(at(k, kSteps));
    }
    return {std::move(pieces), power, std::move(sieves)};
}

} // namespace frostfill
