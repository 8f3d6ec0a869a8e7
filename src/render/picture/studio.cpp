// SPDX-License-Identifier: MIT
#include "render/picture/studio.hpp"

#include "render/framing/numbers.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace frostfill
{
namespace
{

/// Towards the lamp in eye space, before it is raised a little.
const glm::dvec3 kLamp(-0.50, 0.50, 0.72);
constexpr float kRaised = 0.4F;

} // namespace

bool Studio::showsGround(const Framing& framing) const
{
    return ground &&
           glm::dot(glm::vec3(framing.eye), up) > (framing.orthographic ? 0 : ground->level);
}

void Studio::light(const Framing& framing, SphereUniforms& uniforms) const
{
    const glm::mat3 toEye(framing.view);
    uniforms.lamp = toEye * lamp;
    uniforms.above = toEye * up;
}

std::optional<Studio> studioOf(const TriangleMesh& mesh, const RenderSettings& settings,
                               const Framing& framing)
{
    if (settings.style.look != Look::studio)
    {
        return {};
    }
    Studio studio;
    studio.up = unitVector(settings.up);
    const glm::dmat3 toUnit = glm::transpose(glm::dmat3(framing.view));
    studio.lamp = glm::normalize(glm::vec3(toUnit * kLamp) + kRaised * studio.up);
    if (settings.style.ground && settings.poses.empty())
    {
        GroundShadow ground =
            groundShadow(mesh, inUnitSpace(mesh, framing), studio.up, studio.lamp);
        if (ground.cells > 0)
        {
            studio.ground = std::move(ground);
        }
    }
    return studio;
}

namespace
{

constexpr int kCells = 56;               ///< of the shadow, along each edge of its square
constexpr float kAround = 0.8F;          ///< of free ground around what may throw a shadow
constexpr float kNearest = 0.02F;        ///< height below which things count as touching
constexpr float kSkyShare = 0.46F;       ///< of the light, where all of the sky is hidden
constexpr float kLampShare = 0.2F;       ///< the shell is clear
constexpr float kMinShadow = 1.0F / 512; ///< less is not seen

/// A square grid on the ground: the lowest height above each cell, infinite where there is nothing.
struct Heights
{
    glm::vec2 corner{0};
    float cell = 1;
    std::vector<float> lowest =
        std::vector<float>(std::size_t{kCells} * kCells, std::numeric_limits<float>::infinity());

    void put(const glm::vec2& place, float height)
    {
        const glm::ivec2 at = glm::ivec2(glm::floor((place - corner) / cell));
        if (at.x >= 0 && at.y >= 0 && at.x < kCells && at.y < kCells)
        {
            const int index = at.y * kCells + at.x;
            float& here = lowest[static_cast<std::size_t>(index)];
            here = std::min(here, height);
        }
    }
    [[nodiscard]] glm::vec2 middle(std::size_t index) const
    {
        const auto at = static_cast<int>(index);
        return corner + cell * (glm::vec2(at % kCells, at / kCells) + 0.5F);
    }
};

/// Axes of the ground, and how a point is seen along them.
struct GroundFrame
{
    glm::vec3 up, across, along;

    explicit GroundFrame(const glm::vec3& upwards)
        : up(upwards), across(horizontalDirection({up.x, up.y, up.z}, 90)),
          along(horizontalDirection({up.x, up.y, up.z}, 0))
    {
    }
    [[nodiscard]] glm::vec2 flat(const glm::vec3& p) const
    {
        return {glm::dot(p, across), glm::dot(p, along)};
    }
};

/// Calls visit(point) for points all over a triangle, at most `step` apart.
template <typename Visit>
void eachPoint(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, float step, Visit visit)
{
    const float longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    const int parts = std::clamp(static_cast<int>(std::ceil(longest / step)), 1, 400);
    for (int i = 0; i <= parts; ++i)
    {
        for (int k = 0; k + i <= parts; ++k)
        {
            const float u = static_cast<float>(i) / static_cast<float>(parts);
            const float v = static_cast<float>(k) / static_cast<float>(parts);
            visit(a + u * (b - a) + v * (c - a));
        }
    }
}

/// Share of the sky that is hidden from a place: each cell of what is above as a level patch.
float skyHidden(const Heights& above, const glm::vec2& place)
{
    float sum = 0;
    for (std::size_t i = 0; i < above.lowest.size(); ++i)
    {
        if (std::isfinite(above.lowest[i]))
        {
            const float height = std::max(above.lowest[i], kNearest + 0.5F * above.cell);
            const glm::vec2 way = above.middle(i) - place;
            const float squared = glm::dot(way, way) + height * height;
            sum += height * height / (squared * squared);
        }
    }
    return std::min(sum * above.cell * above.cell / static_cast<float>(M_PI), 1.0F);
}

/// Share of the lamp: what is high above throws a wide and faint shadow.
float lampHidden(const Heights& thrown, const glm::vec2& place)
{
    float sum = 0;
    for (std::size_t i = 0; i < thrown.lowest.size(); ++i)
    {
        if (std::isfinite(thrown.lowest[i]))
        {
            const float radius = 1.5F * thrown.cell + shading::kLampSoftness * thrown.lowest[i];
            const glm::vec2 way = thrown.middle(i) - place;
            const float inside = 1 - glm::dot(way, way) / (radius * radius);
            sum += inside > 0 ? 2 * inside / (static_cast<float>(M_PI) * radius * radius) : 0;
        }
    }
    return std::min(sum * thrown.cell * thrown.cell, 1.0F);
}

} // namespace

GroundShadow groundShadow(const TriangleMesh& mesh, std::span<const glm::vec3> positions,
                          const glm::vec3& up, const glm::vec3& towardsLamp)
{
    GroundShadow ground;
    const GroundFrame frame(up);
    const float rise = glm::dot(towardsLamp, up);
    if (positions.empty() || rise < 0.05F)
    {
        return ground;
    }
    glm::vec2 low(std::numeric_limits<float>::infinity());
    glm::vec2 high = -low;
    ground.level = std::numeric_limits<float>::infinity();
    for (const glm::vec3& position : positions)
    {
        ground.level = std::min(ground.level, glm::dot(position, up));
        low = glm::min(low, frame.flat(position));
        high = glm::max(high, frame.flat(position));
    }
    const glm::vec2 shift =
        frame.flat(towardsLamp) / rise; // of a shadow, for each length of height
    const float edge = std::max(high.x - low.x, high.y - low.y) + 2 * kAround;
    Heights above;
    above.corner = (low + high) * 0.5F - edge * 0.5F;
    above.cell = edge / kCells;
    Heights thrown = above;
    for (const auto& [a, b, c] : mesh.triangles)
    {
        eachPoint(positions[a], positions[b], positions[c], 0.7F * above.cell,
                  [&](const glm::vec3& point)
                  {
                      const float height = glm::dot(point, up) - ground.level;
                      above.put(frame.flat(point), height);
                      thrown.put(frame.flat(point) - height * shift, height);
                  });
    }
    for (int y = 0; y <= kCells; ++y)
    {
        for (int x = 0; x <= kCells; ++x)
        {
            const glm::vec2 place = above.corner + above.cell * glm::vec2(x, y);
            const float light = (1 - kSkyShare * skyHidden(above, place)) *
                                (1 - kLampShare * lampHidden(thrown, place));
            // Nothing is dark at the rim.
            const glm::vec2 fromRim = glm::vec2(std::min(x, kCells - x), std::min(y, kCells - y));
            const float inside = std::min(std::min(fromRim.x, fromRim.y) / 10.0F, 1.0F);
            const glm::vec3 point =
                place.x * frame.across + place.y * frame.along + ground.level * up;
            ground.places.emplace_back(point, (1 - light) * inside * inside * (3 - 2 * inside));
        }
    }
    const bool anyDark = std::any_of(ground.places.begin(), ground.places.end(),
                                     [](const glm::vec4& place) { return place.w > kMinShadow; });
    ground.cells = anyDark ? kCells : 0;
    return ground;
}

} // namespace frostfill
