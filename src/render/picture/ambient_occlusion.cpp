// SPDX-License-Identifier: MIT
#include "render/picture/ambient_occlusion.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr int kSamples = 16;
constexpr double kTurns = 7; ///< of the spiral on which samples lie; coprime to their number

/// Neighbouring pixels take turned spirals, which a blur over as many pixels evens out.
constexpr int kTile = 4;

/// What lies less steeply than this above a surface's plane does not shade it: the surface itself
/// does, seen through the rounding of its normals.
constexpr float kBias = 0.06F;

/// How dark the deepest shade is, and how much of the sky it takes to get there.
constexpr float kDarkest = 0.22F;
constexpr float kGain = 5.0F;

/// Samples are spread over at most so many pixels; further away it is one shade.
constexpr double kMaxPixels = 160;
constexpr double kMinPixels = 1.5;

class Occlusion
{
public:
    Occlusion(const Surfaces& surfaces, const Framing& framing, double reach)
        : surfaces_(surfaces), framing_(framing), reach_(static_cast<float>(reach)),
          pixelScale_(0.5 * framing.projection[1][1] * surfaces.height)
    {
        for (int turn = 0; turn < kTile * kTile; ++turn)
        {
            for (int i = 0; i < kSamples; ++i)
            {
                const double share = (i + 0.5) / kSamples;
                const double angle =
                    2 * M_PI * (share * kTurns + static_cast<double>(turn) / (kTile * kTile));
                ways_[static_cast<std::size_t>(turn * kSamples + i)] = {share, std::cos(angle),
                                                                        std::sin(angle)};
            }
        }
    }

    [[nodiscard]] float at(int x, int y) const
    {
        const std::size_t own = index(x, y);
        const float distance = surfaces_.distance[own];
        if (distance == Surfaces::kNothing)
        {
            return 1;
        }
        const double pixels = std::min(
            kMaxPixels, reach_ * pixelScale_ / (framing_.orthographic ? 1 : double{distance}));
        if (pixels < kMinPixels)
        {
            return 1;
        }
        const glm::vec3 point = place(x, y, distance);
        const auto& bytes = surfaces_.normal[own];
        const glm::vec3 normal = glm::vec3(bytes[0], bytes[1], bytes[2]) / 127.5F - 1.0F;
        float sum = 0;
        const int turn = (x % kTile) * kTile + y % kTile;
        for (int i = 0; i < kSamples; ++i)
        {
            const auto& [share, right, down] = ways_[static_cast<std::size_t>(turn * kSamples + i)];
            sum += shadeFrom(x + nearest(share * pixels * right),
                             y + nearest(share * pixels * down), point, normal);
        }
        return std::max(kDarkest, 1 - kGain * sum / kSamples);
    }

    /// Halves away from zero.
    [[nodiscard]] static int nearest(double value)
    {
        return static_cast<int>(value + (value < 0 ? -0.5 : 0.5));
    }

    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(surfaces_.width) +
               static_cast<std::size_t>(x);
    }

private:
    [[nodiscard]] glm::vec3 place(int x, int y, float distance) const
    {
        const glm::dmat4& p = framing_.projection;
        const double ndcX = 2 * (x + 0.5) / surfaces_.width - 1;
        const double ndcY = 1 - 2 * (y + 0.5) / surfaces_.height;
        const double d = double{distance};
        return framing_.orthographic
                   ? glm::vec3((ndcX - p[3][0]) / p[0][0], (ndcY - p[3][1]) / p[1][1], -d)
                   : glm::vec3(d * (ndcX + p[2][0]) / p[0][0], d * (ndcY + p[2][1]) / p[1][1], -d);
    }

    [[nodiscard]] float shadeFrom(int x, int y, const glm::vec3& point,
                                  const glm::vec3& normal) const
    {
        if (x < 0 || y < 0 || x >= surfaces_.width || y >= surfaces_.height)
        {
            return 0;
        }
        const float distance = surfaces_.distance[index(x, y)];
        if (distance == Surfaces::kNothing)
        {
            return 0;
        }
        const glm::vec3 way = place(x, y, distance) - point;
        const float squared = glm::dot(way, way);
        const float steep = glm::dot(way, normal) / std::sqrt(squared + 1e-12F) - kBias;
        return std::max(0.0F, steep) * std::max(0.0F, 1 - squared / (reach_ * reach_));
    }

    const Surfaces& surfaces_;
    const Framing& framing_;
    float reach_;
    /// Where samples lie: share of the way, and its direction.
    std::array<std::array<double, 3>, static_cast<std::size_t>(kTile* kTile* kSamples)> ways_{};
    double pixelScale_; ///< pixels in a length of 1 at distance 1
};

template <class Row>
void forEachRow(int height, Row row)
{
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 16),
                      [&](const tbb::blocked_range<int>& rows)
                      {
                          for (int y = rows.begin(); y < rows.end(); ++y)
                          {
                              row(y);
                          }
                      });
}

} // namespace

std::vector<float> ambientLight(const Surfaces& surfaces, const Framing& framing, double reach)
{
    const Occlusion occlusion(surfaces, framing, reach);
    std::vector<float> rough(surfaces.distance.size());
    forEachRow(surfaces.height,
               [&](int y)
               {
                   for (int x = 0; x < surfaces.width; ++x)
                   {
                       rough[occlusion.index(x, y)] = occlusion.at(x, y);
                   }
               });
    // The mean over a tile's worth of neighbours on the same surface.
    std::vector<float> light(rough.size());
    const auto step = static_cast<float>(reach / 2);
    forEachRow(
        surfaces.height,
        [&](int y)
        {
            for (int x = 0; x < surfaces.width; ++x)
            {
                const std::size_t own = occlusion.index(x, y);
                const float distance = surfaces.distance[own];
                float sum = 0;
                float count = 0;
                for (int v = std::max(0, y - 2); v < std::min(surfaces.height, y + 2); ++v)
                {
                    for (int u = std::max(0, x - 2); u < std::min(surfaces.width, x + 2); ++u)
                    {
                        const std::size_t other = occlusion.index(u, v);
                        const bool near = std::abs(surfaces.distance[other] - distance) < step;
                        sum += near ? rough[other] : 0;
                        count += near ? 1.0F : 0.0F;
                    }
                }
                light[own] = count > 0 ? sum / count : 1;
            }
        });
    return light;
}

void applyAmbientLight(const std::vector<float>& light, Image& image)
{
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < light.size(); ++i)
    {
        std::uint8_t* pixel = image.pixels.data() + i * channels;
        for (std::size_t c = 0; light[i] < 1 && c < 3; ++c)
        {
            pixel[c] =
                static_cast<std::uint8_t>(std::lround(static_cast<float>(pixel[c]) * light[i]));
        }
    }
}

} // namespace frostfill
