// SPDX-License-Identifier: MIT
#include <frostfill/image.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace frostfill
{
namespace
{

/// A pixel counts as different if a channel differs by more than this.
constexpr int kApart = 8;

bool sameShape(const Image& a, const Image& b)
{
    return a.width == b.width && a.height == b.height && a.channels == b.channels &&
           a.pixels.size() == b.pixels.size();
}

} // namespace

ImageDifference compareImages(const Image& a, const Image& b)
{
    ImageDifference difference;
    difference.sameShape = sameShape(a, b);
    if (!difference.sameShape || a.pixels.empty())
    {
        return difference;
    }

    double squares = 0;
    const auto channels = static_cast<std::size_t>(a.channels);
    for (std::size_t pixel = 0; pixel < a.pixels.size(); pixel += channels)
    {
        int worst = 0;
        for (std::size_t i = pixel; i < pixel + channels; ++i)
        {
            const int apart = std::abs(int{a.pixels[i]} - int{b.pixels[i]});
            squares += apart * apart;
            worst = std::max(worst, apart);
        }
        difference.largest = std::max(difference.largest, worst);
        difference.pixelsApart += worst > kApart ? 1 : 0;
    }
    difference.rootMeanSquare = std::sqrt(squares / static_cast<double>(a.pixels.size()));
    return difference;
}

} // namespace frostfill
