// SPDX-License-Identifier: MIT
// How triangles of the shell look in the picture.
#include "render/raster/setup_columns.hpp"
#include "render/raster/shell_raster.hpp"
#include "render/raster/shell_sides.hpp"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <algorithm>

namespace frostfill
{
namespace
{

using namespace lanes;
using Setup = ShellRaster::Setup;

constexpr float kPlainLine = line_strength::kPlain / 255.0F;
constexpr float kStrongLine = line_strength::kStrong / 255.0F;
// The numbers of common.glsl and mesh.frag.
constexpr float kOutlineFrom = 1;
constexpr float kOutlineTo = 2.5F;
constexpr float kCreaseFade = 6;

/// Light and angle change evenly over small triangles whose normals differ by less than the angle
/// of this cosine.
constexpr float kFlat = 0.96F;

struct Vectors
{
    Floats x, y, z;
};

FROSTFILL_INLINE Floats dot(const Vectors& a, const Vectors& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

FROSTFILL_INLINE Floats along(const Vectors& a, float x, float y, float z)
{
    return a.x * x + a.y * y + a.z * z;
}

FROSTFILL_INLINE Floats lightOn(const Vectors& normal)
{
    return lightOf(normal.y, along(normal, -0.424F, 0.636F, 0.645F),
                   along(normal, 0.802F, 0.134F, 0.582F), along(normal, 0.258F, 0.602F, -0.756F));
}

FROSTFILL_INLINE Floats fades(float from, float to, Floats value)
{
    const Floats t = clamped((value - from) / (to - from));
    return t * t * (3 - 2 * t);
}

/// From the square of a gradient: the length over which a value changes by 1. [pixel]
FROSTFILL_INLINE Floats pixelsOf(Floats square)
{
    return 1 / root(max(square, 1e-12F));
}

/// Slopes of the barycentric coordinates in the middle of each triangle.
struct Slopes
{
    std::array<Floats, 3> x, y;

    FROSTFILL_INLINE explicit Slopes(const ShellSides<Floats>& sides)
    {
        // The coordinates are all 1/3 where share * distance is the same for all three; its value
        // there is 1 / (3 w) with w the mean of the corners'.
        Floats w{};
        Floats sumX{};
        Floats sumY{};
        for (std::size_t i = 0; i < 3; ++i)
        {
            w += sides.divisors[i] / 3;
            sumX += x[i] = sides.share[i] * sides.across[i];
            sumY += y[i] = sides.share[i] * sides.upwards[i];
        }
        for (std::size_t i = 0; i < 3; ++i)
        {
            x[i] = w * (x[i] - sumX / 3);
            y[i] = w * (y[i] - sumY / 3);
        }
    }
    /// Of the steepest coordinate.
    [[nodiscard]] FROSTFILL_INLINE Floats pixels() const
    {
        Floats most{};
        for (std::size_t i = 0; i < 3; ++i)
        {
            most = max(x[i] * x[i] + y[i] * y[i], most);
        }
        return pixelsOf(most);
    }
    /// Of a value that is known at the corners.
    [[nodiscard]] FROSTFILL_INLINE Floats pixelsOfValue(const std::array<Floats, 3>& values) const
    {
        const Floats ofX = values[0] * x[0] + values[1] * x[1] + values[2] * x[2];
        const Floats ofY = values[0] * y[0] + values[1] * y[1] + values[2] * y[2];
        return pixelsOf(ofX * ofX + ofY * ofY);
    }
};

template <class ValueOf>
FROSTFILL_INLINE Floats eight(ValueOf valueOf)
{
    return Floats{valueOf(0), valueOf(1), valueOf(2), valueOf(3),
                  valueOf(4), valueOf(5), valueOf(6), valueOf(7)};
}

FROSTFILL_INLINE void setSides(const ShellSides<Floats>& sides, SetupColumns& columns)
{
    for (std::size_t i = 0; i < 3; ++i)
    {
        columns.across[i] = sides.across[i];
        columns.upwards[i] = sides.upwards[i];
        columns.from[i] = sides.from[i];
        columns.least[i] = sides.least[i];
        columns.share[i] = sides.share[i];
        columns.near[i] = sides.near[i];
    }
}

/// Returns how strongly others' creases are drawn.
FROSTFILL_INLINE Floats creases(const ShadedMesh& mesh,
                                const std::array<std::uint32_t, kLanes>& triangles,
                                const Slopes& slopes, Floats sizeInLines, Floats ofLine,
                                SetupColumns& columns)
{
    std::array<Floats, 3> distances = {all(1), all(1), all(1)};
    Floats crease{};
    Floats pixels{};
    if (!mesh.creaseDistances.empty())
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            distances[i] = eight([&](std::size_t lane) __attribute__((always_inline)) {
                return mesh.creaseDistances[triangles[lane]][i];
            });
        }
        pixels = slopes.pixelsOfValue(distances);
        const Floats fade = 1 - fades(0.5F * kCreaseFade, kCreaseFade, sizeInLines);
        crease = select(pixels < 1e5F, ofLine * kStrongLine * fade, Floats{});
    }
    columns.crease = crease;
    columns.pixelsOfCrease = pixels;
    for (std::size_t i = 0; i < 3; ++i)
    {
        columns.creaseDistance[i] = distances[i];
    }
    return crease;
}

} // namespace

template <class Slopes, class Columns>
FROSTFILL_INLINE void ShellRaster::setSurfaces(const Some& some, const Slopes& slopes,
                                               Columns& columns) const
{
    const glm::mat3 view(view_);
    const auto& triangles = some.triangles;
    const Floats towards = eight([&](std::size_t lane) __attribute__((always_inline)) {
        return places_[triangles[lane]].front ? 1.0F : -1.0F;
    });
    std::array<Vectors, 3> normals;
    std::array<Floats, 3> facing;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto ofNormal = [&](glm::length_t axis) __attribute__((always_inline))
        {
            return eight([&](std::size_t lane) __attribute__((always_inline)) {
                return mesh_.normals[triangles[lane]][i][axis];
            });
        };
        const auto ofRay = [&](glm::length_t axis) __attribute__((always_inline))
        {
            return eight([&](std::size_t lane) __attribute__((always_inline)) {
                return vertices_[mesh_.triangles[triangles[lane]][i]].ray[axis];
            });
        };
        const Vectors own = {ofNormal(0), ofNormal(1), ofNormal(2)};
        Vectors& normal = normals[i];
        normal.x = towards * along(own, view[0].x, view[1].x, view[2].x);
        normal.y = towards * along(own, view[0].y, view[1].y, view[2].y);
        normal.z = towards * along(own, view[0].z, view[1].z, view[2].z);
        const Floats length = max(root(dot(normal, normal)), 1e-6F);
        facing[i] = -dot(normal, {ofRay(0), ofRay(1), ofRay(2)}) / length;
        const Floats light =
            0.55F + 0.45F * lightOn({normal.x / length, normal.y / length, normal.z / length});
        columns.normals[i][0] = normal.x;
        columns.normals[i][1] = normal.y;
        columns.normals[i][2] = normal.z;
        columns.light[i] = light;
        columns.facing[i] = edgeOn_ ? Floats{} : facing[i];
    }
    const Mask alike = min(min(dot(normals[0], normals[1]), dot(normals[1], normals[2])),
                           dot(normals[2], normals[0])) > kFlat;
    columns.alike = alike;
    columns.pixelsOfFacing = slopes.pixelsOfValue(facing);
}

template <class Slopes, class Columns>
FROSTFILL_INLINE void ShellRaster::setStrokes(const Some& some, const Slopes& slopes,
                                              Columns& columns) const
{
    const auto& triangles = some.triangles;
    std::array<const Paint*, kLanes> paints;
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
        paints[lane] = &paintOf(states_[triangles[lane]], places_[triangles[lane]].front);
    }
    const auto ofPaint = [&](float Paint::*member) __attribute__((always_inline))
    {
        return eight([&](std::size_t lane)
                         __attribute__((always_inline)) { return paints[lane]->*member; });
    };
    const Floats ofLine = ofPaint(&Paint::ofLine);
    const Floats size = slopes.pixels();
    const Floats edges =
        ofPaint(&Paint::ofEdges) * fades(strokes_.edgeFade[0], strokes_.edgeFade[1], size);
    const Floats outline = fades(kOutlineFrom, kOutlineTo, size / strokes_.lineWidth);
    Mask drawnEdges{};
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Floats strength = eight([&](std::size_t lane) __attribute__((always_inline)) {
                                    return static_cast<float>(edges_[triangles[lane]][i]);
                                }) /
                                255;
        Floats shown = all(1);
        shown = select(strength < kPlainLine + 0.002F, edges, shown);
        shown = select(strength > kStrongLine + 0.002F, outline, shown);
        const Floats drawn = ofLine * shown * min(strength, kStrongLine);
        drawnEdges |= drawn > 0;
        columns.strength[i] = drawn;
    }
    const Floats contour = ofLine * kStrongLine * (1 - outline);
    columns.contour = contour;
    const Mask lines =
        drawnEdges | (contour > 0) |
        (creases(mesh_, triangles, slopes, size / strokes_.lineWidth, ofLine, columns) > 0);
    columns.drawnEdges = drawnEdges;
    columns.lines = lines;
}

FROSTFILL_INLINE void ShellRaster::setUpAny(const Some& some,
                                            std::array<Setup, kLanes>& setups) const
{
    const auto& triangles = some.triangles;
    const auto half = [&](std::size_t first) __attribute__((always_inline))
    {
        return sidesOf(Corners<Vertex>(
            vertices_, mesh_.triangles, [&](std::size_t lane) __attribute__((always_inline)) {
                return triangles[first + lane];
            }));
    };
    const ShellSides<Floats> sides = joined(half(0), half(kHalf));
    const Slopes slopes(sides);
    SetupColumns columns;
    setSides(sides, columns);
    setSurfaces(some, slopes, columns);
    setStrokes(some, slopes, columns);
    write(columns, setups);
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
        Setup& setup = setups[lane];
        const Place& place = places_[triangles[lane]];
        const Paint& paint = paintOf(states_[triangles[lane]], place.front);
        setup.base = paint.base;
        setup.ink = paint.ink;
        setup.density = paint.density;
        setup.rimDensity = paint.rimDensity;
        setup.edges = columns.drawnEdges[lane] != 0;
        setup.lines = columns.lines[lane] != 0;
        setup.seen = setup.lines || setup.density > 0;
        setup.flat = columns.alike[lane] != 0 && place.small;
    }
}

FROSTFILL_AVX2 void ShellRaster::setUpAvx2(const Some& some,
                                           std::array<Setup, kLanes>& setups) const
{
    setUpAny(some, setups);
}

void ShellRaster::setUpPlain(const Some& some, std::array<Setup, kLanes>& setups) const
{
    setUpAny(some, setups);
}

} // namespace frostfill
