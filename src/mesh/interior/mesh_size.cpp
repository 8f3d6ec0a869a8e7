// SPDX-License-Identifier: MIT
#include <frostfill/mesh.hpp>

#include <cmath>

namespace frostfill
{

double signedVolume(const TriangleMesh& mesh)
{
    // Relative to the middle, so a small object far from the origin loses no digits.
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    const Eigen::Vector3d middle = box.isEmpty() ? Eigen::Vector3d::Zero().eval() : box.center();
    double sixfold = 0;
    for (const auto& t : mesh.triangles)
    {
        const Eigen::Vector3d a = mesh.vertices[t[0]] - middle;
        const Eigen::Vector3d b = mesh.vertices[t[1]] - middle;
        const Eigen::Vector3d c = mesh.vertices[t[2]] - middle;
        sixfold += a.dot(b.cross(c));
    }
    return sixfold / 6;
}

double surfaceArea(const TriangleMesh& mesh)
{
    double twice = 0;
    for (const auto& t : mesh.triangles)
    {
        const Eigen::Vector3d& a = mesh.vertices[t[0]];
        twice += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    }
    return twice / 2;
}

Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh)
{
    Eigen::AlignedBox3d box;
    for (const auto& t : mesh.triangles)
    {
        for (const std::uint32_t corner : t)
        {
            box.extend(mesh.vertices[corner]);
        }
    }
    return box;
}

namespace
{

constexpr double kTwoPi = 6.283185307179586;

/// Neumaier's compensated sum, so the rounding of a million terms of either sign does not add up.
class CarefulSum
{
public:
    void add(double value)
    {
        const double sum = sum_ + value;
        lost_ += std::abs(sum_) >= std::abs(value) ? (sum_ - sum) + value : (value - sum) + sum_;
        sum_ = sum;
    }
    [[nodiscard]] double value() const { return sum_ + lost_; }

private:
    double sum_ = 0;
    double lost_ = 0;
};

/// [4 pi] Signed solid angle of a triangle seen from a point: at most 1/2, and finite everywhere.
double solidAngle(const TriangleMesh& mesh, std::size_t triangle, const Eigen::Vector3d& point)
{
    const auto& t = mesh.triangles[triangle];
    const Eigen::Vector3d a = mesh.vertices[t[0]] - point;
    const Eigen::Vector3d b = mesh.vertices[t[1]] - point;
    const Eigen::Vector3d c = mesh.vertices[t[2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double numerator = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    return std::atan2(numerator, denominator) / kTwoPi;
}

} // namespace

double windingNumber(const TriangleMesh& mesh, const Eigen::Vector3d& point)
{
    CarefulSum sum;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
    {
        sum.add(solidAngle(mesh, triangle, point));
    }
    return sum.value();
}

} // namespace frostfill
