// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of the interior: the mesh is cut where it meets itself, all parts are exact; a part
// stays if the winding number is at least 1 on one side only. Once the cuts are made, one winding
// number decides for a whole patch.
#include "arrangement.hpp"
#include "work.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace frostfill::wrap
{
namespace
{

/// How far a winding number may be from a whole one, for rounding. [1]
constexpr double kWhole = 0.1;
/// Parts of a patch at which it is tried: the largest ones.
constexpr std::size_t kTries = 8;

Eigen::Vector3d rounded(const Exact::Point_3& p)
{
    return {CGAL::to_double(CGAL::exact(p.x())), CGAL::to_double(CGAL::exact(p.y())),
            CGAL::to_double(CGAL::exact(p.z()))};
}

class Union
{
public:
    explicit Union(const TriangleMesh& mesh) : cut_(arrange(mesh))
    {
        for (const Exact::Point_3& p : cut_.points)
        {
            rounded_.push_back(rounded(p));
        }
        for (const Part& part : cut_.parts)
        {
            keepOneOfEach(part);
        }
        flood();
    }

    [[nodiscard]] TriangleMesh surface() const
    {
        TriangleMesh result;
        std::map<std::array<double, 3>, std::uint32_t> numbers;
        const auto numberOf = [&](std::uint32_t point)
        {
            const Eigen::Vector3d& p = rounded_[point];
            // -0 and 0 are one place.
            const auto [found, isNew] =
                numbers.try_emplace({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0},
                                    static_cast<std::uint32_t>(result.vertices.size()));
            if (isNew)
            {
                result.vertices.push_back(p);
            }
            return found->second;
        };
        for (const Face& face : faces_)
        {
            const bool inFront = face.front >= 1;
            const bool behind = face.front + face.step >= 1;
            if (inFront == behind)
            {
                continue;
            }
            std::array<std::uint32_t, 3> t = {numberOf(face.corners[0]), numberOf(face.corners[1]),
                                              numberOf(face.corners[2])};
            if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            {
                continue; // rounded away
            }
            if (inFront)
            {
                std::swap(t[1], t[2]);
            }
            result.triangles.push_back(t);
        }
        return result;
    }

private:
    /// A part of the surface, of which there may be several sheets.
    struct Face
    {
        Corners corners;
        std::vector<std::uint32_t> sheets; ///< triangles of the mesh that it is a part of
        int step = 1;                      ///< winding number behind minus that in front
        int front = 0;                     ///< winding number in front, once it is known
        std::size_t patch = kNone;
    };
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// Where sheets lie on each other, only the part of the first one stays.
    void keepOneOfEach(const Part& part)
    {
        Face face{part.corners, {part.triangle}};
        const auto& overlaps = cut_.overlaps[part.triangle];
        if (!overlaps.empty())
        {
            const Exact::Triangle_3 shape = cut_.shape(part.corners);
            const Exact::Point_3 middle = CGAL::centroid(shape);
            const Exact::Vector_3 normal = CGAL::normal(shape[0], shape[1], shape[2]);
            for (const std::uint32_t other : overlaps)
            {
                const Exact::Triangle_3 sheet = cut_.shape(cut_.triangles[other]);
                if (!sheet.has_on(middle))
                {
                    continue;
                }
                if (other < part.triangle)
                {
                    return;
                }
                face.sheets.push_back(other);
                const Exact::Vector_3 its = CGAL::normal(sheet[0], sheet[1], sheet[2]);
                face.step += CGAL::sign(normal * its) == CGAL::POSITIVE ? 1 : -1;
            }
        }
        faces_.push_back(std::move(face));
    }

    struct Side
    {
        std::size_t face;
        bool forward; ///< from the lower vertex to the higher
    };

    /// Gives all faces that hang together at edges of two the winding numbers of the largest.
    void flood()
    {
        std::map<std::array<std::uint32_t, 2>, std::vector<Side>> edges;
        for (std::size_t i = 0; i < faces_.size(); ++i)
        {
            for (std::size_t k = 0; k < 3; ++k)
            {
                const std::uint32_t a = faces_[i].corners[k];
                const std::uint32_t b = faces_[i].corners[(k + 1) % 3];
                edges[{std::min(a, b), std::max(a, b)}].push_back({i, a < b});
            }
        }
        std::vector<std::vector<std::pair<std::size_t, bool>>> links(faces_.size());
        for (const auto& [edge, sides] : edges)
        {
            if (sides.size() == 2)
            {
                const bool agree = sides[0].forward != sides[1].forward;
                links[sides[0].face].emplace_back(sides[1].face, agree);
                links[sides[1].face].emplace_back(sides[0].face, agree);
            }
        }
        for (std::size_t seed = 0; seed < faces_.size(); ++seed)
        {
            if (faces_[seed].patch == kNone)
            {
                floodPatch(seed, links);
            }
        }
    }

    void floodPatch(std::size_t seed,
                    const std::vector<std::vector<std::pair<std::size_t, bool>>>& links)
    {
        std::vector<std::pair<std::size_t, bool>> patch = {{seed, true}}; // faces as the seed does
        faces_[seed].patch = seed;
        for (std::size_t i = 0; i < patch.size(); ++i)
        {
            const auto [face, as] = patch[i];
            for (const auto& [next, agree] : links[face])
            {
                if (faces_[next].patch == kNone)
                {
                    faces_[next].patch = seed;
                    patch.emplace_back(next, as == agree);
                }
            }
        }
        const auto [known, asSeed] = decide(patch);
        for (const auto& [face, as] : patch)
        {
            Face& f = faces_[face];
            const Face& k = faces_[known];
            f.front = as == asSeed ? k.front : k.front + k.step;
            f.step = as == asSeed ? k.step : -k.step;
        }
    }

    /// The face of a patch whose winding numbers are now known.
    std::pair<std::size_t, bool> decide(std::vector<std::pair<std::size_t, bool>> patch)
    {
        const std::size_t tries = std::min(kTries, patch.size());
        std::partial_sort(
            patch.begin(), patch.begin() + static_cast<std::ptrdiff_t>(tries), patch.end(),
            [&](const auto& a, const auto& b) { return areaOf(a.first) > areaOf(b.first); });
        for (std::size_t i = 0; i < tries; ++i)
        {
            Face& face = faces_[patch[i].first];
            const double front = meanWinding(face) - 0.5 * face.step;
            if (std::abs(front - std::round(front)) < kWhole)
            {
                face.front = static_cast<int>(std::round(front));
                return patch[i];
            }
        }
        const Eigen::Vector3d p = middleOf(faces_[patch[0].first]);
        throw Refused("its winding number is not whole near " + std::to_string(p.x()) + " " +
                      std::to_string(p.y()) + " " + std::to_string(p.z()));
    }

    [[nodiscard]] Eigen::Vector3d middleOf(const Face& face) const
    {
        return (rounded_[face.corners[0]] + rounded_[face.corners[1]] + rounded_[face.corners[2]]) /
               3;
    }
    [[nodiscard]] double areaOf(std::size_t face) const
    {
        const Corners& c = faces_[face].corners;
        return (rounded_[c[1]] - rounded_[c[0]]).cross(rounded_[c[2]] - rounded_[c[0]]).norm();
    }

    /// Mean of the winding numbers on both sides: that of all triangles but its own sheets
    /// [van Oosterom & Strackee 1983].
    [[nodiscard]] double meanWinding(const Face& face) const
    {
        const Eigen::Vector3d p = middleOf(face);
        const std::set<std::uint32_t> own(face.sheets.begin(), face.sheets.end());
        double sum = 0;
        for (std::uint32_t i = 0; i < cut_.triangles.size(); ++i)
        {
            if (own.count(i) > 0)
            {
                continue;
            }
            const Eigen::Vector3d a = rounded_[cut_.triangles[i][0]] - p;
            const Eigen::Vector3d b = rounded_[cut_.triangles[i][1]] - p;
            const Eigen::Vector3d c = rounded_[cut_.triangles[i][2]] - p;
            const double la = a.norm();
            const double lb = b.norm();
            const double lc = c.norm();
            sum += 2 * std::atan2(a.dot(b.cross(c)),
                                  la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
        }
        return sum / (4 * std::numbers::pi);
    }

    Arrangement cut_;
    std::vector<Eigen::Vector3d> rounded_; ///< the points
    std::vector<Face> faces_;
};

/// Whether as many triangles pass each edge in one direction as in the other.
bool isClosed(const TriangleMesh& mesh)
{
    std::map<std::array<std::uint32_t, 2>, int> sums;
    for (const auto& t : mesh.triangles)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            sums[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    return std::all_of(sums.begin(), sums.end(), [](const auto& edge) { return edge.second == 0; });
}

} // namespace

TriangleMesh unionOf(const TriangleMesh& mesh)
{
    TriangleMesh surface = Union(mesh).surface();
    if (!isClosed(surface))
    {
        throw Refused("the boundary of its interior did not come out closed");
    }
    return surface;
}

} // namespace frostfill::wrap
