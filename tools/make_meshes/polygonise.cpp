// SPDX-License-Identifier: MIT
// Marching tetrahedra. Each cell is cut into the six tetrahedra around its main diagonal, which
// agree across cells, so the surface is closed and manifold without a table of cases.
#include "surface.hpp"

#include <cstdint>
#include <unordered_map>

namespace
{

constexpr double kGradientStep = 1e-4; // [m] far below every feature, far above rounding
constexpr double kMeaningfulGradient = 1e-3;

Eigen::Vector3d gradient(const Field& field, const Eigen::Vector3d& point)
{
    Eigen::Vector3d slope;
    for (int axis = 0; axis < 3; ++axis)
    {
        const Eigen::Vector3d step = kGradientStep * Eigen::Vector3d::Unit(axis);
        slope[axis] = (field(point + step) - field(point - step)) / (2 * kGradientStep);
    }
    return slope;
}

class Polygoniser
{
public:
    Polygoniser(const Field& field, const Eigen::AlignedBox3d& box, double cell)
        : origin_(box.min()), cell_(cell),
          counts_((box.sizes() / cell).array().ceil().cast<int>() + 1)
    {
        values_.reserve(static_cast<std::size_t>(counts_.prod()));
        for (int z = 0; z < counts_.z(); ++z)
        {
            for (int y = 0; y < counts_.y(); ++y)
            {
                for (int x = 0; x < counts_.x(); ++x)
                {
                    values_.push_back(field(position(index(x, y, z))));
                }
            }
        }
    }

    Triangles run()
    {
        // Corners of a cell are numbered by bits (x, y, z); a tetrahedron walks from 0 to 7.
        constexpr int kTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                           {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
        for (int z = 0; z + 1 < counts_.z(); ++z)
        {
            for (int y = 0; y + 1 < counts_.y(); ++y)
            {
                for (int x = 0; x + 1 < counts_.x(); ++x)
                {
                    for (const auto& corners : kTetrahedra)
                    {
                        std::array<int, 4> nodes{};
                        for (int i = 0; i < 4; ++i)
                        {
                            nodes[i] = index(x + (corners[i] & 1), y + (corners[i] >> 1 & 1),
                                             z + (corners[i] >> 2));
                        }
                        addTetrahedron(nodes);
                    }
                }
            }
        }
        return std::move(mesh_);
    }

private:
    int index(int x, int y, int z) const { return (z * counts_.y() + y) * counts_.x() + x; }

    Eigen::Vector3d position(int node) const
    {
        const int x = node % counts_.x();
        const int y = node / counts_.x() % counts_.y();
        const int z = node / (counts_.x() * counts_.y());
        return origin_ + cell_ * Eigen::Vector3d(x, y, z);
    }

    int cut(int inner, int outer)
    {
        const auto key = static_cast<std::uint64_t>(inner) << 32 | static_cast<unsigned>(outer);
        const auto [place, isNew] = cuts_.try_emplace(key, static_cast<int>(mesh_.vertices.size()));
        if (isNew)
        {
            const double share = values_[inner] / (values_[inner] - values_[outer]);
            mesh_.vertices.push_back(position(inner) + share * (position(outer) - position(inner)));
        }
        return place->second;
    }

    /// An edge from an inner to an outer node.
    using Crossing = std::array<int, 2>;

    /// Adds a triangle so that it faces outwards. Which way that is depends on the nodes alone, so
    /// it is judged with the cuts half-way, where no triangle is without area.
    void addFace(const Crossing& a, const Crossing& b, const Crossing& c)
    {
        const auto middle = [&](const Crossing& e) -> Eigen::Vector3d
        { return 0.5 * (position(e[0]) + position(e[1])); };
        const Eigen::Vector3d normal = (middle(b) - middle(a)).cross(middle(c) - middle(a));
        const bool outwards = normal.dot(position(a[1]) - position(a[0])) > 0;
        const int first = cut(a[0], a[1]), second = cut(b[0], b[1]), third = cut(c[0], c[1]);
        mesh_.faces.push_back(outwards ? std::array{first, second, third}
                                       : std::array{first, third, second});
    }

    void addTetrahedron(const std::array<int, 4>& nodes)
    {
        std::vector<int> in;
        std::vector<int> out;
        for (const int node : nodes)
        {
            (values_[node] < 0 ? in : out).push_back(node);
        }
        if (in.empty() || out.empty())
        {
            return;
        }
        if (in.size() == 1)
        {
            addFace({in[0], out[0]}, {in[0], out[1]}, {in[0], out[2]});
        }
        else if (out.size() == 1)
        {
            addFace({in[0], out[0]}, {in[1], out[0]}, {in[2], out[0]});
        }
        else
        {
            addFace({in[0], out[0]}, {in[0], out[1]}, {in[1], out[1]});
            addFace({in[0], out[0]}, {in[1], out[1]}, {in[1], out[0]});
        }
    }

    Eigen::Vector3d origin_;
    double cell_;
    Eigen::Array3i counts_;
    std::vector<double> values_;
    std::unordered_map<std::uint64_t, int> cuts_; // looked up only, so its order does not matter
    Triangles mesh_;
};

} // namespace

Triangles polygonise(const Field& field, const Eigen::AlignedBox3d& box, double cell)
{
    return Polygoniser(field, box, cell).run();
}

Eigen::Vector3d projectToSurface(const Field& field, Eigen::Vector3d point)
{
    for (int step = 0; step < 3; ++step)
    {
        const Eigen::Vector3d slope = gradient(field, point);
        const double steepness = slope.squaredNorm();
        if (steepness > kMeaningfulGradient)
        {
            point -= field(point) * slope / steepness;
        }
    }
    return point;
}
