// SPDX-License-Identifier: MIT
// How triangles of the shell that are no specks look in the picture.
#include "render/raster/shell/setup_columns.hpp"
#include "render/raster/shell/shell_looks.hpp"

namespace frostfill
{
namespace
{

using namespace lanes;
using Setup = ShellRaster::Setup;

/// Light and angle change evenly over small triangles whose normals differ by less than the angle
/// of this cosine, 6 degrees: their film is then seldom one level off. At 16 degrees it was so in a
/// quarter of its pixels.
constexpr float kFlat = 0.995F;

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

} // namespace

template <class Columns>
FROSTFILL_INLINE void ShellRaster::setSurfaces(const Triangles& triangles,
                                               const lanes::Slopes& slopes, Columns& columns) const
{
    const auto ends = [&](std::size_t first) __attribute__((always_inline))
    {
        return Corners<PlacedVertex>(
            placed_, shape_.triangles, [&](std::size_t lane) __attribute__((always_inline)) {
                return triangles[first + lane];
            });
    };
    setLight(triangles, ends(0), ends(kHalf), slopes, columns);
    std::array<Vectors, 3> normals;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto ofNormal = [&](int axis) __attribute__((always_inline))
        {
            return eight([&](std::size_t lane) __attribute__((always_inline)) {
                const std::uint32_t t = triangles[lane];
                const float value = vertices_[shape_.triangles[t][i]].normal[axis];
                return places_[t].front ? value : -value;
            });
        };
        normals[i] = {ofNormal(0), ofNormal(1), ofNormal(2)};
        columns.normals[i] = {normals[i].x, normals[i].y, normals[i].z};
    }
    const Mask alike = min(min(dot(normals[0], normals[1]), dot(normals[1], normals[2])),
                           dot(normals[2], normals[0])) > kFlat;
    columns.alike = alike;
}

FROSTFILL_INLINE void ShellRaster::setUpAny(const Triangles& triangles,
                                            std::array<Setup, kLanes>& setups) const
{
    const auto half = [&](std::size_t first) __attribute__((always_inline))
    {
        return sidesOf(Corners<Vertex>(
            vertices_, shape_.triangles, [&](std::size_t lane) __attribute__((always_inline)) {
                return triangles[first + lane];
            }));
    };
    const ShellSides<Floats> sides = joined(half(0), half(kHalf));
    const Slopes slopes(sides);
    SetupColumns columns;
    setSides(sides, columns);
    setSurfaces(triangles, slopes, columns);
    setStrokes(triangles, PaintLanes(*this, triangles), slopes, columns);
    write(columns, setups);
    for (std::size_t lane = 0; lane < kLanes; ++lane)
    {
        Setup& setup = setups[lane];
        const Place& place = places_[triangles[lane]];
        const Paint& paint = paintOf(states_[triangles[lane]], place.front);
        setup.base = paint.base;
        setup.ink = paint.ink;
        setup.density = paint.own.density;
        setup.rimDensity = paint.own.rimDensity;
        setup.cut = place.cut;
        setup.edges = columns.edges[lane] != 0;
        setup.lines = columns.lines[lane] != 0 || place.cut;
        setup.seen = setup.lines || setup.density > 0;
        setup.flat = columns.alike[lane] != 0 && place.small;
    }
}

FROSTFILL_AVX2 void ShellRaster::setUpAvx2(const Triangles& triangles,
                                           std::array<Setup, kLanes>& setups) const
{
    setUpAny(triangles, setups);
}

void ShellRaster::setUpPlain(const Triangles& triangles, std::array<Setup, kLanes>& setups) const
{
    setUpAny(triangles, setups);
}

} // namespace frostfill
