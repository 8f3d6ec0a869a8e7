// SPDX-License-Identifier: MIT
#include "render/picture/shrink.hpp"

#include <algorithm>
#include <array>

namespace frostfill
{

Image shrunk(const Image& image, int factor)
{
    Image small;
    small.width = std::max(1, image.width / factor);
    small.height = std::max(1, image.height / factor);
    small.channels = image.channels;
    small.pixels.resize(static_cast<std::size_t>(small.width) *
                        static_cast<std::size_t>(small.height) *
                        static_cast<std::size_t>(small.channels));
    std::uint8_t* to = small.pixels.data();
    for (int y = 0; y < small.height; ++y)
    {
        for (int x = 0; x < small.width; ++x, to += small.channels)
        {
            std::array<unsigned, 3> sum{};
            unsigned weight = 0;
            for (int v = y * factor; v < (y + 1) * factor && v < image.height; ++v)
            {
                for (int u = x * factor; u < (x + 1) * factor && u < image.width; ++u)
                {
                    const std::uint8_t* from = image.at(u, v);
                    const unsigned alpha = image.channels == 4 ? from[3] : 255;
                    weight += alpha;
                    for (std::size_t c = 0; c < 3; ++c)
                    {
                        sum[c] += alpha * from[c];
                    }
                }
            }
            for (std::size_t c = 0; c < 3; ++c)
            {
                to[c] = static_cast<std::uint8_t>(weight == 0 ? 0 : (sum[c] + weight / 2) / weight);
            }
            if (image.channels == 4)
            {
                const auto pixels = static_cast<unsigned>(factor * factor);
                to[3] = static_cast<std::uint8_t>((weight + pixels / 2) / pixels);
            }
        }
    }
    return small;
}

} // namespace frostfill
