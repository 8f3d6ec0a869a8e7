// SPDX-License-Identifier: MIT
#include "surface.hpp"

#include <cmath>
#include <map>
#include <tuple>

namespace
{

constexpr double kTurn = 6.283185307179586;

void addQuad(Surface& surface, int a, int b, int c, int d)
{
    surface.faces.push_back({a, b, c});
    surface.faces.push_back({a, c, d});
}

} // namespace

Surface makeTorus(double radius, double tube, int around, int across)
{
    Surface surface;
    for (int i = 0; i < around; ++i)
    {
        for (int j = 0; j < across; ++j)
        {
            const double alongRing = kTurn * i / around;
            const double alongTube = kTurn * j / across;
            const double distance = radius + tube * std::cos(alongTube);
            surface.vertices.emplace_back(distance * std::cos(alongRing),
                                          distance * std::sin(alongRing),
                                          tube * std::sin(alongTube));
        }
    }
    const auto index = [&](int i, int j) { return (i % around) * across + j % across; };
    for (int i = 0; i < around; ++i)
    {
        for (int j = 0; j < across; ++j)
        {
            addQuad(surface, index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
        }
    }
    return surface;
}

Surface makeSphere(double radius, int around, int rings)
{
    Surface surface;
    surface.vertices.emplace_back(0, radius, 0);
    for (int i = 1; i < rings; ++i)
    {
        for (int j = 0; j < around; ++j)
        {
            const double fromPole = 0.5 * kTurn * i / rings;
            const double longitude = kTurn * j / around;
            surface.vertices.emplace_back(radius * std::sin(fromPole) * std::sin(longitude),
                                          radius * std::cos(fromPole),
                                          radius * std::sin(fromPole) * std::cos(longitude));
        }
    }
    surface.vertices.emplace_back(0, -radius, 0);

    const int south = static_cast<int>(surface.vertices.size()) - 1;
    const auto index = [&](int i, int j) { return 1 + (i - 1) * around + j % around; };
    for (int j = 0; j < around; ++j)
    {
        surface.faces.push_back({0, index(1, j), index(1, j + 1)});
    }
    for (int i = 1; i + 1 < rings; ++i)
    {
        for (int j = 0; j < around; ++j)
        {
            addQuad(surface, index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
        }
    }
    for (int j = 0; j < around; ++j)
    {
        surface.faces.push_back({south, index(rings - 1, j + 1), index(rings - 1, j)});
    }
    return surface;
}

Surface makeCube(double edge, int quadsAlongEdge)
{
    Surface surface;
    std::map<std::tuple<int, int, int>, int> known;
    const auto vertex = [&](const Eigen::Vector3i& grid)
    {
        const auto [place, isNew] = known.try_emplace({grid.x(), grid.y(), grid.z()},
                                                      static_cast<int>(surface.vertices.size()));
        if (isNew)
        {
            surface.vertices.push_back(
                edge * (grid.cast<double>() / quadsAlongEdge - Eigen::Vector3d::Constant(0.5)));
        }
        return place->second;
    };
    // Of each axis the near and the far face; the two other axes in the order that turns outwards.
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const bool far : {false, true})
        {
            const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + (far ? 1 : 2)) % 3);
            const Eigen::Vector3i v = Eigen::Vector3i::Unit((axis + (far ? 2 : 1)) % 3);
            const Eigen::Vector3i base = Eigen::Vector3i::Unit(axis) * (far ? quadsAlongEdge : 0);
            for (int i = 0; i < quadsAlongEdge; ++i)
            {
                for (int j = 0; j < quadsAlongEdge; ++j)
                {
                    const Eigen::Vector3i corner = base + i * u + j * v;
                    // One by one: in a call the compiler may number them in any order.
                    const int a = vertex(corner);
                    const int b = vertex(corner + u);
                    const int c = vertex(corner + u + v);
                    const int d = vertex(corner + v);
                    addQuad(surface, a, b, c, d);
                }
            }
        }
    }
    return surface;
}
