// SPDX-License-Identifier: MIT
// What tests of OSMesa beside tiles share: scenes, and how far pictures are apart.
#pragma once

#include "support/pictures.hpp"

#include <frostfill/image.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace frostfill::test
{

using testing_support::addSphere;
using testing_support::Numbers;

/// What both may differ by: one picture, and the mean of a region of 8x8 pixels. [of 255]
struct Apart
{
    double rms = 0.75;
    double region = 4;
};

/// The largest mean difference of a region of 8x8 pixels, over its channels.
inline double worstRegion(const Image& a, const Image& b)
{
    constexpr int kRegion = 8;
    const int columns = (a.width + kRegion - 1) / kRegion;
    std::vector<double> sums(static_cast<std::size_t>(columns * (a.height / kRegion + 1)));
    for (int y = 0; y < a.height; ++y)
    {
        for (int x = 0; x < a.width; ++x)
        {
            for (int c = 0; c < a.channels; ++c)
            {
                const int region = y / kRegion * columns + x / kRegion;
                sums[static_cast<std::size_t>(region)] += std::abs(a.at(x, y)[c] - b.at(x, y)[c]);
            }
        }
    }
    return *std::max_element(sums.begin(), sums.end()) / (kRegion * kRegion * a.channels);
}

/// The root of the mean square difference without the pixels that differ most. [of 255]
inline double rmsBeside(const Image& a, const Image& b, std::size_t pixels)
{
    const auto channels = static_cast<std::size_t>(a.channels);
    std::vector<double> squares(a.pixels.size() / channels);
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
    {
        const double apart = a.pixels[i] - b.pixels[i];
        squares[i / channels] += apart * apart;
    }
    std::sort(squares.begin(), squares.end());
    squares.resize(squares.size() - pixels);
    double sum = 0;
    for (const double square : squares)
    {
        sum += square;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

/// A mesh with spheres of all states and discarded polygons.
struct Subject
{
    std::string name;
    TriangleMesh mesh;
    Snapshot snapshot;
};

/// Spheres do not overlap: where they do, a cut shows any of them.
inline Subject subjectOf(const std::string& name, const TriangleMesh& mesh, double spacing)
{
    Subject subject{name, mesh, {}};
    Numbers numbers;
    const auto cells = static_cast<int>(2.6 / spacing);
    for (int i = 0; i < cells * cells * cells; ++i)
    {
        const Eigen::Vector3d cell =
            Eigen::Vector3i(i % cells, i / cells % cells, i / (cells * cells)).cast<double>();
        const Eigen::Vector3d jitter(numbers.next(), numbers.next(), numbers.next());
        const double radius = spacing * (0.25 + 0.1 * numbers.next());
        const Eigen::Vector3d centre =
            (cell.array() + 0.5 - 0.5 * cells).matrix() * spacing + 0.25 * spacing * jitter;
        if (numbers.next() < 0.4 && centre.norm() < 1.3)
        {
            addSphere(subject.snapshot, centre, radius,
                      static_cast<SphereState>(static_cast<int>(3 * numbers.next())));
        }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const bool discarded = numbers.next() < 0.3;
        subject.snapshot.polygons.push_back(discarded ? PolygonState::discarded
                                                      : PolygonState::active);
        subject.snapshot.discardedPolygons += discarded ? 1 : 0;
    }
    return subject;
}

} // namespace frostfill::test
