// SPDX-License-Identifier: MIT
#include "mesh/interior/interior_volume.hpp"

#include "mesh/interior/separate_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
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

/// Rows of rays that are looked at together. Larger: what is known of them leaves the cache, and
/// few threads have something to do. Smaller: more triangles lie in several.
constexpr int kRowsTogether = 16;
constexpr int kBands = kRays / kRowsTogether;

/// The rays that pass through a box of the mesh, by the walls that they meet.
class RayGrid
{
public:
    explicit RayGrid(const TriangleMesh& mesh) : mesh_(mesh)
    {
        boundingBox(mesh).sizes().maxCoeff(&along_);
        Eigen::AlignedBox2d box;
        flat_.reserve(mesh.vertices.size());
        for (const Eigen::Vector3d& vertex : mesh.vertices)
        {
            flat_.push_back(flat(vertex));
            box.extend(flat_.back());
        }
        low_ = box.min();
        step_ = box.sizes() / kRays;
    }

    /// The same sum whatever the number of threads: that of one ray after another.
    double volumeInside(Threads& threads)
    {
        sortIntoBands();
        std::vector<std::vector<double>> inside(kBands);
        threads.forEachLarge(kBands, [&](std::size_t band)
                             { inside[band] = lengthsInside(static_cast<int>(band)); });
        double length = 0;
        for (const std::vector<double>& lengths : inside)
        {
            for (const double each : lengths)
            {
                length += each;
            }
        }
        return length * step_[0] * step_[1];
    }

private:
    /// Where a ray passes through a wall.
    struct Passage
    {
        double at;           ///< along the ray
        std::int32_t change; ///< of the winding number
        std::uint32_t ray;   ///< of those of a band
    };
    using Triangle = std::array<std::uint32_t, 3>;

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
    [[nodiscard]] Eigen::AlignedBox2d boxOf(const Triangle& t) const
    {
        return {flat_[t[0]].cwiseMin(flat_[t[1]]).cwiseMin(flat_[t[2]]),
                flat_[t[0]].cwiseMax(flat_[t[1]]).cwiseMax(flat_[t[2]])};
    }

    void sortIntoBands()
    {
        const auto forEachBand = [this](const Triangle& t, auto&& visit)
        {
            const Eigen::AlignedBox2d box = boxOf(t);
            const int last = std::min(kRays, first(box.max().y(), 1) + 1) - 1;
            for (int band = first(box.min().y(), 1) / kRowsTogether;
                 band <= last / kRowsTogether && band < kBands; ++band)
            {
                visit(static_cast<std::size_t>(band));
            }
        };
        for (const Triangle& t : mesh_.triangles)
        {
            forEachBand(t, [&](std::size_t band) { ++starts_[band]; });
        }
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        byBand_.resize(starts_.back());
        for (auto t = static_cast<std::uint32_t>(mesh_.triangles.size()); t-- > 0;)
        {
            forEachBand(mesh_.triangles[t],
                        [&](std::size_t band) { byBand_[--starts_[band]] = t; });
        }
    }

    /// What lies inside of the rays of a band, one after another.
    [[nodiscard]] std::vector<double> lengthsInside(int band) const
    {
        std::vector<Passage> found;
        const auto number = static_cast<std::size_t>(band);
        for (std::uint32_t k = starts_[number]; k < starts_[number + 1]; ++k)
        {
            addPassages(mesh_.triangles[byBand_[k]], band * kRowsTogether, found);
        }
        std::vector<std::uint32_t> ends(std::size_t{kRowsTogether} * kRays, 0);
        for (const Passage& one : found)
        {
            ++ends[one.ray];
        }
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        std::vector<Passage> byRay(found.size());
        for (const Passage& one : found)
        {
            byRay[--ends[one.ray]] = one;
        }
        ends.push_back(static_cast<std::uint32_t>(found.size()));
        std::vector<double> lengths;
        for (std::size_t ray = 0; ray + 1 < ends.size(); ++ray) // ends are starts now
        {
            addInside(std::span(byRay).subspan(ends[ray], ends[ray + 1] - ends[ray]), lengths);
        }
        return lengths;
    }

    /// Of the rays from row `firstRow` on, as many as are looked at together.
    void addPassages(const Triangle& t, int firstRow, std::vector<Passage>& found) const
    {
        const Eigen::Vector2d &pa = flat_[t[0]], &pb = flat_[t[1]], &pc = flat_[t[2]];
        const double area = cross(pb - pa, pc - pa);
        if (area == 0)
        {
            return; // seen edge on
        }
        const Eigen::AlignedBox2d box = boxOf(t);
        const auto depth = [&](std::size_t k) { return mesh_.vertices[t[k]][along_]; };
        for (int v = std::max(firstRow, first(box.min().y(), 1));
             v < firstRow + kRowsTogether && place(v, 1) <= box.max().y(); ++v)
        {
            for (int u = first(box.min().x(), 0); u < kRays && place(u, 0) <= box.max().x(); ++u)
            {
                const Eigen::Vector2d p(place(u, 0), place(v, 1));
                const double shareOfC = cross(pb - pa, p - pa) / area;
                const double shareOfA = cross(pc - pb, p - pb) / area;
                const double shareOfB = 1 - shareOfC - shareOfA;
                if (shareOfA >= 0 && shareOfB >= 0 && shareOfC >= 0)
                {
                    // Seen against the ray counter-clockwise: the ray enters.
                    found.push_back(
                        {shareOfA * depth(0) + shareOfB * depth(1) + shareOfC * depth(2),
                         area > 0 ? -1 : 1,
                         static_cast<std::uint32_t>((v - firstRow) * kRays + u)});
                }
            }
        }
    }

    static void addInside(std::span<Passage> ray, std::vector<double>& lengths)
    {
        std::sort(ray.begin(), ray.end(),
                  [](const Passage& a, const Passage& b) { return a.at < b.at; });
        int winding = 0;
        for (std::size_t k = 0; k + 1 < ray.size(); ++k)
        {
            winding += ray[k].change;
            if (winding > 0)
            {
                lengths.push_back(ray[k + 1].at - ray[k].at);
            }
        }
    }

    const TriangleMesh& mesh_;
    int along_ = 0;
    Eigen::Vector2d low_;
    Eigen::Vector2d step_;
    std::vector<Eigen::Vector2d> flat_; ///< of each vertex
    std::vector<std::uint32_t> starts_ = std::vector<std::uint32_t>(kBands + 1, 0);
    std::vector<std::uint32_t> byBand_; ///< triangles that a band may meet
};

double volumeOfPart(const TriangleMesh& mesh, Threads& threads)
{
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    if (mesh.triangles.empty() || !(box.sizes().minCoeff() > 0))
    {
        return 0;
    }
    return RayGrid(mesh).volumeInside(threads);
}

} // namespace

double interiorVolume(const TriangleMesh& mesh)
{
    Threads one(1);
    return interiorVolume(mesh, one);
}

double interiorVolume(const TriangleMesh& mesh, Threads& threads)
{
    const std::vector<Eigen::AlignedBox3d> boxes = separateBoxes(mesh, 0);
    double filled = 0;
    for (const Eigen::AlignedBox3d& box : boxes)
    {
        filled += box.volume();
    }
    if (filled >= kSparse * boundingBox(mesh).volume())
    {
        return volumeOfPart(mesh, threads);
    }
    double volume = 0;
    for (const TriangleMesh& part : separateParts(mesh, boxes))
    {
        volume += volumeOfPart(part, threads);
    }
    return volume;
}

} // namespace frostfill
