// SPDX-License-Identifier: MIT
#include "mesh/interior/interior_volume.hpp"

#include "mesh/interior/separate_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace frostfill
{
namespace
{

/// Rays along the object's longest side, in each of the two other directions. Larger: a smaller
/// error, and time by the square.
constexpr int kRays = 1024;
/// By which the grid of rays is turned about their direction [rad]: no wall of a box is then along
/// a row of rays, where all of them or none would be inside.
constexpr double kTurn = 0.5;

/// When the parts of a mesh fill less of its box, each has rays of its own. Larger: time, for one
/// grid would do. Smaller: too few rays meet a part.
constexpr double kSparse = 0.02;

/// Where a ray passes through a wall.
struct Passage
{
    double at = 0;  ///< along the ray
    int change = 0; ///< of the winding number
};

/// The rays that pass through a box of the mesh, by the walls that they meet.
class RayGrid
{
public:
    explicit RayGrid(const TriangleMesh& mesh)
    {
        boundingBox(mesh).sizes().maxCoeff(&along_);
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector3d& vertex : mesh.vertices)
        {
            box.extend(flat(vertex));
        }
        low_ = box.min();
        step_ = box.sizes() / kRays;
        passages_.resize(std::size_t{kRays} * kRays);
    }

    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
    {
        const Eigen::Vector2d pa = flat(a), pb = flat(b), pc = flat(c);
        const double area = cross(pb - pa, pc - pa);
        if (area == 0)
        {
            return; // seen edge on
        }
        const Eigen::Vector2d low = pa.cwiseMin(pb).cwiseMin(pc);
        const Eigen::Vector2d high = pa.cwiseMax(pb).cwiseMax(pc);
        for (int v = first(low.y(), 1); v < kRays && place(v, 1) <= high.y(); ++v)
        {
            for (int u = first(low.x(), 0); u < kRays && place(u, 0) <= high.x(); ++u)
            {
                const Eigen::Vector2d p(place(u, 0), place(v, 1));
                const double shareOfC = cross(pb - pa, p - pa) / area;
                const double shareOfA = cross(pc - pb, p - pb) / area;
                const double shareOfB = 1 - shareOfC - shareOfA;
                if (shareOfA >= 0 && shareOfB >= 0 && shareOfC >= 0)
                {
                    const double at =
                        shareOfA * a[along_] + shareOfB * b[along_] + shareOfC * c[along_];
                    // Seen against the ray counter-clockwise: the ray enters.
                    passages_[static_cast<std::size_t>(v) * kRays + static_cast<std::size_t>(u)]
                        .push_back({at, area > 0 ? -1 : 1});
                }
            }
        }
    }

    double volumeInside()
    {
        double length = 0;
        for (std::vector<Passage>& ray : passages_)
        {
            std::sort(ray.begin(), ray.end(),
                      [](const Passage& a, const Passage& b) { return a.at < b.at; });
            int winding = 0;
            for (std::size_t k = 0; k + 1 < ray.size(); ++k)
            {
                winding += ray[k].change;
                length += winding > 0 ? ray[k + 1].at - ray[k].at : 0;
            }
        }
        return length * step_[0] * step_[1];
    }

private:
    static double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    {
        return a.x() * b.y() - a.y() * b.x();
    }
    /// Across the rays, turned.
    [[nodiscard]] Eigen::Vector2d flat(const Eigen::Vector3d& p) const
    {
        const double u = p[(along_ + 1) % 3];
        const double v = p[(along_ + 2) % 3];
        return {std::cos(kTurn) * u - std::sin(kTurn) * v,
                std::sin(kTurn) * u + std::cos(kTurn) * v};
    }
    [[nodiscard]] double place(int ray, int k) const { return low_[k] + (ray + 0.5) * step_[k]; }
    /// The first ray that is not before a place.
    [[nodiscard]] int first(double from, int k) const
    {
        return std::max(0, static_cast<int>(std::ceil((from - low_[k]) / step_[k] - 0.5)));
    }

    int along_ = 0;
    Eigen::Vector2d low_;
    Eigen::Vector2d step_;
    std::vector<std::vector<Passage>> passages_;
};

double volumeOfPart(const TriangleMesh& mesh)
{
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    if (mesh.triangles.empty() || !(box.sizes().minCoeff() > 0))
    {
        return 0;
    }
    RayGrid rays(mesh);
    for (const auto& [a, b, c] : mesh.triangles)
    {
        rays.add(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    }
    return rays.volumeInside();
}

} // namespace

double interiorVolume(const TriangleMesh& mesh)
{
    const std::vector<Eigen::AlignedBox3d> boxes = separateBoxes(mesh, 0);
    double filled = 0;
    for (const Eigen::AlignedBox3d& box : boxes)
    {
        filled += box.volume();
    }
    if (filled >= kSparse * boundingBox(mesh).volume())
    {
        return volumeOfPart(mesh);
    }
    double volume = 0;
    for (const TriangleMesh& part : separateParts(mesh, boxes))
    {
        volume += volumeOfPart(part);
    }
    return volume;
}

} // namespace frostfill
