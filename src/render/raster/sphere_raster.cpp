// SPDX-License-Identifier: MIT
#include "render/raster/sphere_raster.hpp"

#include "render/raster/lanes.hpp"
#include "render/raster/vector_width.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

// The numbers of common.glsl, sphere.vert and sphere.frag.
const glm::vec3 kKeyLight(-0.424F, 0.636F, 0.645F);
const glm::vec3 kFillLight(0.802F, 0.134F, 0.582F);
const glm::vec3 kBackLight(0.258F, 0.602F, -0.756F);
const glm::vec3 kHighlight(-0.234F, 0.351F, 0.907F);
constexpr float kHatchShare = 0.34F;
/// Strength of gloss, ring and hatch for each SphereState.
constexpr std::array<std::array<float, 3>, 3> kMarks = {
    {{0.65F, 0.8F, 0}, {0, 0, 0}, {0, 0, 0.42F}}};

using namespace lanes;
using Setup = SphereRaster::Setup;

/// More than a sample may be from the middle of its row. [pixel]
constexpr float kRowSlack = 0.6F;

FROSTFILL_INLINE Floats stripes(Floats phase, float share, float width)
{
    // Truncating serves for floor: phases are above -4.
    const Floats fraction =
        phase - (__builtin_convertvector(__builtin_convertvector(phase + 4, Mask), Floats) - 4);
    const Floats fromMiddle = most(fraction - 0.5F, 0.5F - fraction);
    const Floats crisp =
        clamped((fromMiddle - 0.5F * (1 - share)) * (1 / std::max(width, 1e-4F)) + 0.5F);
    const float mean = std::clamp(2.5F * width - 0.75F, 0.0F, 1.0F);
    return crisp + (share - crisp) * mean;
}

template <bool marked>
FROSTFILL_INLINE Words shaded(const Setup& s, Floats across, Floats above, Floats rhoSquared,
                              Floats w)
{
    const Floats t = 1 / (1 + s.steepness * w);
    const Floats axis = (s.steepness + w) * t;
    const Floats right = across * t;
    const Floats up = above * t;
    const auto dot = [&](const Setup::Slope& slope) __attribute__((always_inline))
    {
        return axis * slope.axis + right * slope.right + up * slope.above;
    };
    Floats light = lightOf(dot(s.up), dot(s.key), dot(s.fill), dot(s.back)) *
                   (0.64F + 0.36F * least(1.7F * w, 1));
    Floats gloss{};
    if constexpr (marked)
    {
        gloss = most(dot(s.highlight), 0);
        gloss *= gloss;
        gloss *= gloss;
        gloss *= gloss;
        gloss *= gloss;
        gloss *= gloss;
        gloss *= s.gloss;
        const Floats ring = clamped((rhoSquared - 0.76F) * (1 / (2 * s.pixel + 0.02F)) + 0.5F);
        const Floats hatch = stripes((across + above) * 1.3F + 0.25F, kHatchShare, s.pixel * 1.84F);
        light *= 1 - s.ring * ring - s.hatch * hatch;
    }
    return byteOf(s.tint[0] * light + s.haze[0] + gloss) |
           byteOf(s.tint[1] * light + s.haze[1] + gloss) << 8 |
           byteOf(s.tint[2] * light + s.haze[2] + gloss) << 16 | 0xff000000U;
}

/// Columns of the tile in which a row may meet the outline's inside, samples included: where
/// (K D.R)^2 + (K D.A)^2 < (D.C)^2, which is quadratic in dx.
FROSTFILL_INLINE std::array<int, 2> columnsOf(const Setup& s, float aboveRow, float alongRow,
                                              const PixelRectangle& rows, float left)
{
    const float larger = 1 + kRowSlack * s.pixel;
    const float along = alongRow * larger;
    const float alongX = s.alongX * larger;
    const float a = s.acrossX * s.acrossX + s.aboveX * s.aboveX - alongX * alongX;
    const float b = aboveRow * s.aboveX - along * alongX;
    const float c = aboveRow * aboveRow - along * along;
    if (!(a > 0))
    {
        return {rows.left, rows.right}; // it reaches behind the eye
    }
    const float squared = b * b - a * c;
    if (!(squared > 0))
    {
        return {0, 0};
    }
    const float middle = s.x - left - b / a;
    const float half = std::sqrt(squared) / a;
    const float low = std::max(middle - half - 1, static_cast<float>(rows.left));
    const float high = std::min(middle + half + 1, static_cast<float>(rows.right));
    return low < high ? std::array{static_cast<int>(low), static_cast<int>(std::ceil(high))}
                      : std::array{0, 0};
}

template <int samples, bool marked>
FROSTFILL_INLINE void drawRows(const Setup& setup, const PixelRectangle& rows, const TilePart& part,
                               SampleTile& tile)
{
    const Setup s = setup; // so that the tile cannot be part of it
    for (int y = rows.bottom; y < rows.top; ++y)
    {
        const float dy = static_cast<float>(part.bottom + y) + 0.5F - s.y;
        const float aboveRow = s.aboveY * dy;
        const float alongRow = s.along + s.alongY * dy;
        const auto [from, to] =
            columnsOf(s, aboveRow, alongRow, rows, static_cast<float>(part.left));
        for (int x = from & ~(kLanes - 1); x < to; x += kLanes)
        {
            const Floats dx = static_cast<float>(part.left + x) + 0.5F - s.x + counted();
            const Floats acrossK = s.acrossX * dx;
            const Floats aboveK = aboveRow + s.aboveX * dx;
            const Floats along = alongRow + s.alongX * dx;
            const Floats over = 1 / along;
            const Floats across = acrossK * over;
            const Floats above = aboveK * over;
            const Floats rhoSquared = across * across + above * above;
            const Floats w = root(most(1 - rhoSquared, 0));
            const Floats q = along * s.nearScale;
            const Floats isNear = q + (q * s.steepness + s.rise) * w;
            const std::size_t at = static_cast<std::size_t>(y * kTileEdge + x);
            std::array<Mask, samples> seen;
            Mask seenAtAll{};
            for (std::size_t k = 0; k < samples; ++k)
            {
                const Floats a = acrossK + s.acrossAt[k];
                const Floats b = aboveK + s.aboveAt[k];
                const Floats c = along + s.alongAt[k];
                float* held = tile.nearness[k].data() + at;
                const auto before = load<Floats>(held);
                seen[k] = (a * a + b * b < c * c) & (c > 0) & (isNear > before);
                seenAtAll |= seen[k];
                store(chosen(seen[k], isNear, before), held);
            }
            if (!any(seenAtAll))
            {
                continue;
            }
            const Words rgba = shaded<marked>(s, across, above, rhoSquared, w);
            for (std::size_t k = 0; k < samples; ++k)
            {
                std::uint32_t* shown = tile.colour[k].data() + at;
                store(chosen(seen[k], rgba, load<Words>(shown)), shown);
            }
        }
    }
}

template <int samples>
FROSTFILL_INLINE void drawAny(const Setup& setup, const PixelRectangle& rows, const TilePart& part,
                              SampleTile& tile)
{
    if (setup.gloss + setup.ring + setup.hatch > 0)
    {
        drawRows<samples, true>(setup, rows, part, tile);
    }
    else
    {
        drawRows<samples, false>(setup, rows, part, tile);
    }
}

FROSTFILL_INLINE void drawSamples(int samples, const Setup& setup, const PixelRectangle& rows,
                                  const TilePart& part, SampleTile& tile)
{
    if (samples > 1)
    {
        drawAny<kMostTileSamples>(setup, rows, part, tile);
    }
    else
    {
        drawAny<1>(setup, rows, part, tile);
    }
}

FROSTFILL_AVX2 void drawAvx2(int samples, const Setup& setup, const PixelRectangle& rows,
                             const TilePart& part, SampleTile& tile)
{
    drawSamples(samples, setup, rows, part, tile);
}

void drawPlain(int samples, const Setup& setup, const PixelRectangle& rows, const TilePart& part,
               SampleTile& tile)
{
    drawSamples(samples, setup, rows, part, tile);
}

} // namespace

PixelGrid pixelGrid(const glm::mat4& projection, bool orthographic, const PictureSize& size)
{
    PixelGrid grid;
    grid.orthographic = orthographic;
    const float shiftX = orthographic ? -projection[3][0] : projection[2][0];
    const float shiftY = orthographic ? -projection[3][1] : projection[2][1];
    grid.left = (shiftX - 1) / projection[0][0];
    grid.bottom = (shiftY - 1) / projection[1][1];
    grid.perColumn = 2 / (projection[0][0] * static_cast<float>(size.width));
    grid.perRow = 2 / (projection[1][1] * static_cast<float>(size.height));
    return grid;
}

SphereRaster::SphereRaster(const SphereUniforms& uniforms, bool orthographic,
                           const PictureSize& size, const Colour& background, int samples,
                           float front)
    : uniforms_(uniforms), grid_(pixelGrid(uniforms.projection, orthographic, size)),
      background_(glm::vec3(toVector(background)) * toVector(background).a), samples_(samples),
      front_(front)
{
}

void SphereRaster::setColours(const SphereInstance& sphere, const glm::vec3& centre,
                              Setup& setup) const
{
    const glm::vec4 point(centre, 1);
    const float foot =
        0.86F + 0.14F * glm::clamp(glm::dot(uniforms_.heightPlane, point), 0.0F, 1.0F);
    const float far =
        uniforms_.haze * glm::clamp(glm::dot(uniforms_.distancePlane, point), 0.0F, 1.0F);
    const float distance = grid_.orthographic ? 1 : -centre.z;
    setup.pixel = distance / (uniforms_.pixelScale * sphere.radius);
    const auto& marks = kMarks[sphere.state];
    setup.gloss = 255 * marks[0];
    setup.ring = marks[1];
    // On small spheres a hatch is noise. It fades to its mean, and is gone at 12 pixels across.
    const float shown = glm::smoothstep(12.0F, 120.0F, 2 / setup.pixel);
    setup.hatch = marks[2] * shown;
    const float dimmed = foot * (1 - far) * (1 - kHatchShare * marks[2] * (1 - shown));
    for (int c = 0; c < 3; ++c)
    {
        const auto channel = static_cast<std::size_t>(c);
        setup.tint[channel] = static_cast<float>(sphere.colour[channel]) * dimmed;
        setup.haze[channel] = 255 * background_[c] * far;
    }
}

bool SphereRaster::setUp(const SphereInstance& sphere, Setup& setup) const
{
    const glm::vec3 centre(uniforms_.view * glm::vec4(sphere.x, sphere.y, sphere.z, 1));
    const float radius = sphere.radius;
    glm::vec3 right(1, 0, 0);
    glm::vec3 above(0, 1, 0);
    glm::vec3 axis(0, 0, -1); // towards the centre
    float shrink = 1;
    if (grid_.orthographic)
    {
        setup.x = (centre.x - grid_.left) / grid_.perColumn;
        setup.y = (centre.y - grid_.bottom) / grid_.perRow;
        setup.acrossX = grid_.perColumn / radius;
        setup.aboveX = 0;
        setup.aboveY = grid_.perRow / radius;
        setup.along = 1;
        setup.alongX = setup.alongY = 0;
        setup.steepness = 0;
        setup.nearScale = centre.z + front_;
        setup.rise = radius;
    }
    else
    {
        const float squared = glm::dot(centre, centre);
        const float distance = std::sqrt(squared);
        const float steepness = radius / distance;
        if (steepness >= 1 || centre.z >= 0)
        {
            return false; // the eye is in the sphere or past it
        }
        axis = centre / distance;
        right = glm::normalize(glm::vec3(-centre.z, 0, centre.x));
        above = glm::cross(centre, right) / -distance;
        shrink = std::sqrt(1 - steepness * steepness);
        const float scale = squared * shrink / radius; // K
        setup.x = (centre.x / -centre.z - grid_.left) / grid_.perColumn;
        setup.y = (centre.y / -centre.z - grid_.bottom) / grid_.perRow;
        setup.acrossX = scale * grid_.perColumn * right.x;
        setup.aboveX = scale * grid_.perColumn * above.x;
        setup.aboveY = scale * grid_.perRow * above.y;
        setup.along = squared / -centre.z;
        setup.alongX = grid_.perColumn * centre.x;
        setup.alongY = grid_.perRow * centre.y;
        setup.steepness = steepness;
        setup.nearScale = 1 / (squared - radius * radius);
        setup.rise = 0;
    }
    const auto slope = [&](const glm::vec3& way)
    {
        return Setup::Slope{-glm::dot(axis, way), shrink * glm::dot(right, way),
                            shrink * glm::dot(above, way)};
    };
    setup.up = slope({0, 1, 0});
    setup.key = slope(kKeyLight);
    setup.fill = slope(kFillLight);
    setup.back = slope(kBackLight);
    setup.highlight = slope(kHighlight);
    for (std::size_t k = 0; k < kMostTileSamples; ++k)
    {
        const SampleOffset at = samples_ > 1 ? kFourSamples[k] : SampleOffset{};
        setup.acrossAt[k] = setup.acrossX * at.x;
        setup.aboveAt[k] = setup.aboveX * at.x + setup.aboveY * at.y;
        setup.alongAt[k] = setup.alongX * at.x + setup.alongY * at.y;
    }
    setColours(sphere, centre, setup);
    return true;
}

float SphereRaster::nearest(const SphereInstance& sphere) const
{
    const glm::mat4& view = uniforms_.view;
    const float z =
        view[0][2] * sphere.x + view[1][2] * sphere.y + view[2][2] * sphere.z + view[3][2];
    if (grid_.orthographic)
    {
        return z + 1.0001F * sphere.radius + 1e-5F + front_;
    }
    const float ahead = -z - 1.0001F * sphere.radius;
    return ahead > 0 ? 1.00001F / ahead : std::numeric_limits<float>::max();
}

void SphereRaster::draw(const SphereInstance& sphere, const PixelRectangle& pixels,
                        const TilePart& part, SampleTile& tile) const
{
    const PixelRectangle rows = part.within(pixels);
    Setup setup;
    if (rows.empty() || !setUp(sphere, setup))
    {
        return;
    }
    (lanes::usesAvx2() ? drawAvx2 : drawPlain)(samples_, setup, rows, part, tile);
}

} // namespace frostfill
