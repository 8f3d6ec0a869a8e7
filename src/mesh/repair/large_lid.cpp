// SPDX-License-Identifier: MIT
#include "mesh/repair/large_lid.hpp"

#include "mesh/repair/least_lid.hpp"

#include <queue>

namespace frostfill
{
namespace
{

/// Longer rims get a fan: cutting ears takes seconds.
constexpr std::size_t kMaxClippedEdges = 20000;

/// Twice the area vector of a closed path.
Eigen::Vector3d normalOf(const TriangleMesh& mesh, const Rim& rim)
{
    const Eigen::Vector3d& origin = mesh.vertices[rim[0]];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < rim.size(); ++i)
    {
        sum += (mesh.vertices[rim[i]] - origin).cross(mesh.vertices[rim[i + 1]] - origin);
    }
    return sum;
}

/// Cuts ears off a polygon until a triangle is left.
class EarClipper
{
public:
    EarClipper(const TriangleMesh& mesh, const EdgeTable& edges, const Rim& rim)
        : mesh_(mesh), edges_(edges), rim_(rim)
    {
        const Eigen::Vector3d normal = normalOf(mesh, rim).normalized();
        const Eigen::Vector3d across = normal.unitOrthogonal();
        const Eigen::Vector3d up = normal.cross(across);
        for (std::size_t i = 0; i < rim.size(); ++i)
        {
            const Eigen::Vector3d p = mesh.vertices[rim[i]] - mesh.vertices[rim[0]];
            points_.emplace_back(across.dot(p), up.dot(p));
            before_.push_back((i + rim.size() - 1) % rim.size());
            after_.push_back((i + 1) % rim.size());
        }
        age_.assign(rim.size(), 0);
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d& p : points_)
        {
            box.extend(p);
        }
        nothing_ = kNothing * box.diagonal().squaredNorm();
        for (std::size_t i = 0; i < rim.size(); ++i)
        {
            if (turn(i) <= nothing_)
            {
                notConvex_.push_back(i);
            }
        }
        for (std::size_t i = 0; i < rim.size(); ++i)
        {
            offer(i);
        }
    }

    /// Empty if it gets stuck.
    [[nodiscard]] std::vector<Triangle> clip()
    {
        std::vector<Triangle> ears;
        std::size_t left = rim_.size();
        while (left > 3 && !offers_.empty())
        {
            const Offer best = offers_.top();
            offers_.pop();
            if (best.age != age_[best.corner] || !isEar(best.corner))
            {
                continue;
            }
            const std::size_t a = before_[best.corner];
            const std::size_t c = after_[best.corner];
            ears.push_back({rim_[a], rim_[best.corner], rim_[c]});
            age_[best.corner] = kGone;
            after_[a] = c;
            before_[c] = a;
            --left;
            // A corner beside the ear may only now be one, or a fatter one. Others that its corner
            // stood in the way of are offered again, too.
            for (const std::size_t corner : {a, c})
            {
                ++age_[corner];
                offer(corner);
            }
            offerBlockedBy(best.corner);
            last_ = a;
        }
        if (left > 3)
        {
            return {};
        }
        const Triangle last = {rim_[before_[last_]], rim_[last_], rim_[after_[last_]]};
        if (isFlat(mesh_, last))
        {
            return {};
        }
        ears.push_back(last);
        return ears;
    }

private:
    struct Offer
    {
        double fatness;
        std::size_t corner;
        std::size_t age;
        friend bool operator<(const Offer& a, const Offer& b)
        {
            return a.fatness != b.fatness ? a.fatness < b.fatness : a.corner > b.corner;
        }
    };
    static constexpr std::size_t kGone = static_cast<std::size_t>(-1);
    /// Twice an area over the square of the rim's size that is rounding. Corners in a line have it.
    static constexpr double kNothing = 1e-14;

    [[nodiscard]] double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                              const Eigen::Vector2d& c) const
    {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    }
    /// Twice the area of the triangle at a corner; positive where the polygon is convex.
    [[nodiscard]] double turn(std::size_t i) const
    {
        return turn(points_[before_[i]], points_[i], points_[after_[i]]);
    }

    void offer(std::size_t i)
    {
        const double area = turn(i);
        if (area > nothing_)
        {
            const Eigen::Vector2d& a = points_[before_[i]];
            const Eigen::Vector2d& c = points_[after_[i]];
            const double squares = (points_[i] - a).squaredNorm() + (c - points_[i]).squaredNorm() +
                                   (a - c).squaredNorm();
            offers_.push({area / squares, i, age_[i]});
        }
    }

    /// Offers again the convex corners in whose triangle this one lay.
    void offerBlockedBy(std::size_t gone)
    {
        std::vector<std::size_t>& waiting = blocked_[gone];
        for (const std::size_t corner : waiting)
        {
            if (age_[corner] != kGone)
            {
                offer(corner);
            }
        }
        waiting.clear();
    }

    /// If a corner that is not convex lies in its triangle, the ear waits for that one's end.
    [[nodiscard]] bool isEar(std::size_t i)
    {
        const std::size_t a = before_[i];
        const std::size_t c = after_[i];
        if (isFlat(mesh_, {rim_[a], rim_[i], rim_[c]}) || !edges_.find(rim_[a], rim_[c]).empty())
        {
            return false;
        }
        for (const std::size_t k : notConvex_)
        {
            if (age_[k] == kGone || k == a || k == i || k == c)
            {
                continue;
            }
            if (turn(points_[a], points_[i], points_[k]) >= -nothing_ &&
                turn(points_[i], points_[c], points_[k]) >= -nothing_ &&
                turn(points_[c], points_[a], points_[k]) >= -nothing_)
            {
                blocked_[k].push_back(i);
                return false;
            }
        }
        return true;
    }

    const TriangleMesh& mesh_;
    const EdgeTable& edges_;
    const Rim& rim_;
    std::vector<Eigen::Vector2d> points_; ///< the rim in its plane
    std::vector<std::size_t> before_;
    std::vector<std::size_t> after_;
    std::vector<std::size_t> age_;       ///< how often a corner got a new neighbour
    std::vector<std::size_t> notConvex_; ///< at the start; cutting ears makes no others
    std::map<std::size_t, std::vector<std::size_t>> blocked_;
    std::priority_queue<Offer> offers_;
    double nothing_ = 0; ///< twice an area that is rounding
    std::size_t last_ = 0;
};

} // namespace

std::vector<Triangle> clippedLid(const TriangleMesh& mesh, const EdgeTable& edges, const Rim& rim)
{
    return normalOf(mesh, rim).norm() > 0 ? EarClipper(mesh, edges, rim).clip()
                                          : std::vector<Triangle>{};
}

std::vector<Triangle> fanLid(TriangleMesh& mesh, const Rim& rim)
{
    // Weighted by lengths, the middle does not depend on how finely a part of the rim is cut.
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double length = 0;
    const Eigen::Vector3d origin = mesh.vertices[rim[0]];
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
        const Eigen::Vector3d a = mesh.vertices[rim[i]] - origin;
        const Eigen::Vector3d b = mesh.vertices[rim[(i + 1) % rim.size()]] - origin;
        sum += (b - a).norm() * (a + b) / 2;
        length += (b - a).norm();
    }
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(origin + sum / length);
    std::vector<Triangle> fan;
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
        fan.push_back({rim[i], rim[(i + 1) % rim.size()], middle});
    }
    return fan;
}

std::vector<Triangle> largeLid(TriangleMesh& mesh, const EdgeTable& edges, const Rim& rim)
{
    std::vector<Triangle> lid;
    if (rim.size() <= kMaxEdgesOfLeastLid)
    {
        lid = leastLid(mesh, edges, rim);
    }
    if (lid.empty() && rim.size() <= kMaxClippedEdges)
    {
        lid = clippedLid(mesh, edges, rim);
    }
    return lid.empty() ? fanLid(mesh, rim) : lid;
}

} // namespace frostfill
