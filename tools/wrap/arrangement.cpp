// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <map>

namespace frostfill::wrap
{
namespace
{

using Fast = CGAL::Exact_predicates_inexact_constructions_kernel;
using Segment = std::array<Exact::Point_3, 2>;

/// What others leave on a triangle.
struct Marks
{
    std::vector<Exact::Point_3> points;
    std::vector<Segment> segments;

    [[nodiscard]] bool none() const { return points.empty() && segments.empty(); }
};

/// Numbers exact points; equal ones get the same number.
class PointNumbers
{
public:
    explicit PointNumbers(std::vector<Exact::Point_3>& points) : points_(points) {}

    std::uint32_t of(const Exact::Point_3& p)
    {
        const auto [found, isNew] =
            numbers_.try_emplace(p, static_cast<std::uint32_t>(points_.size()));
        if (isNew)
        {
            points_.push_back(p);
        }
        return found->second;
    }

private:
    struct Less
    {
        bool operator()(const Exact::Point_3& a, const Exact::Point_3& b) const
        {
            return CGAL::compare_lexicographically(a, b) == CGAL::SMALLER;
        }
    };
    std::map<Exact::Point_3, std::uint32_t, Less> numbers_;
    std::vector<Exact::Point_3>& points_;
};

/// Finds out where triangles meet other than at shared corners and edges.
class Contacts
{
public:
    Contacts(Arrangement& arrangement, const std::vector<Fast::Point_3>& fast)
        : arrangement_(arrangement), fast_(fast), marks(arrangement.triangles.size())
    {
        using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
        std::vector<Box> boxes;
        for (std::uint32_t i = 0; i < arrangement.triangles.size(); ++i)
        {
            const Corners& t = arrangement.triangles[i];
            boxes.emplace_back(fast[t[0]].bbox() + fast[t[1]].bbox() + fast[t[2]].bbox(), i);
        }
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                      [&](const Box& a, const Box& b)
                                      { meet(a.info(), b.info()); });
    }

private:
    Arrangement& arrangement_;
    const std::vector<Fast::Point_3>& fast_;

public:
    std::vector<Marks> marks; ///< [#T]

private:
    /// Rotated so that the corners that both have come first. Returns how many there are.
    static std::size_t align(Corners& a, Corners& b)
    {
        std::size_t shared = 0;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const auto found = std::find(b.begin() + shared, b.end(), a[i]);
            if (found != b.end())
            {
                std::iter_swap(b.begin() + shared, found);
                std::swap(a[shared], a[i]);
                ++shared;
            }
        }
        return shared;
    }

    [[nodiscard]] Fast::Triangle_3 fastShape(const Corners& t) const
    {
        return {fast_[t[0]], fast_[t[1]], fast_[t[2]]};
    }

    [[nodiscard]] bool meetsElsewhere(Corners a, Corners b) const
    {
        switch (align(a, b))
        {
        case 0:
            return CGAL::do_intersect(fastShape(a), fastShape(b));
        case 1:
            return CGAL::do_intersect(Fast::Segment_3(fast_[a[1]], fast_[a[2]]), fastShape(b)) ||
                   CGAL::do_intersect(Fast::Segment_3(fast_[b[1]], fast_[b[2]]), fastShape(a));
        case 2:
            return CGAL::coplanar(fast_[a[0]], fast_[a[1]], fast_[a[2]], fast_[b[2]]) &&
                   CGAL::coplanar_orientation(fast_[a[0]], fast_[a[1]], fast_[a[2]], fast_[b[2]]) ==
                       CGAL::POSITIVE;
        default:
            return true;
        }
    }

    void meet(std::uint32_t i, std::uint32_t j)
    {
        const Corners& a = arrangement_.triangles[i];
        const Corners& b = arrangement_.triangles[j];
        if (!meetsElsewhere(a, b))
        {
            return;
        }
        const auto where = CGAL::intersection(arrangement_.shape(a), arrangement_.shape(b));
        if (!where)
        {
            return;
        }
        if (const auto* point = boost::get<Exact::Point_3>(&*where))
        {
            marks[i].points.push_back(*point);
            marks[j].points.push_back(*point);
        }
        else if (const auto* segment = boost::get<Exact::Segment_3>(&*where))
        {
            addSegment(i, j, segment->source(), segment->target());
        }
        else if (const auto* triangle = boost::get<Exact::Triangle_3>(&*where))
        {
            addArea(i, j, {(*triangle)[0], (*triangle)[1], (*triangle)[2]});
        }
        else if (const auto* polygon = boost::get<std::vector<Exact::Point_3>>(&*where))
        {
            addArea(i, j, *polygon);
        }
    }

    void addSegment(std::uint32_t i, std::uint32_t j, const Exact::Point_3& a,
                    const Exact::Point_3& b)
    {
        marks[i].segments.push_back({a, b});
        marks[j].segments.push_back({a, b});
    }

    void addArea(std::uint32_t i, std::uint32_t j, const std::vector<Exact::Point_3>& polygon)
    {
        arrangement_.overlaps[i].push_back(j);
        arrangement_.overlaps[j].push_back(i);
        for (std::size_t k = 0; k < polygon.size(); ++k)
        {
            addSegment(i, j, polygon[k], polygon[(k + 1) % polygon.size()]);
        }
    }
};

/// Cuts one triangle along its marks: a constrained Delaunay triangulation, seen along the axis
/// nearest to the normal.
class Cutter
{
public:
    Cutter(const Exact::Triangle_3& shape)
        : shape_(shape), normal_(CGAL::normal(shape[0], shape[1], shape[2]))
    {
        for (int axis = 1; axis < 3; ++axis)
        {
            if (CGAL::abs(normal_[axis]) > CGAL::abs(normal_[down_]))
            {
                down_ = axis;
            }
        }
    }

    template <class Visit>
    void cut(const Marks& marks, Visit&& visit)
    {
        Cdt cdt;
        for (int i = 0; i < 3; ++i)
        {
            cdt.insert_constraint(flat(shape_[i]), flat(shape_[(i + 1) % 3]));
        }
        for (const Exact::Point_3& p : marks.points)
        {
            cdt.insert(flat(p));
        }
        for (const Segment& s : marks.segments)
        {
            if (s[0] != s[1])
            {
                cdt.insert_constraint(flat(s[0]), flat(s[1]));
            }
        }
        const bool keeps = CGAL::sign(normal_[down_]) == CGAL::POSITIVE;
        for (const auto face : cdt.finite_face_handles())
        {
            const Exact::Point_3 a = lifted(face->vertex(0)->point());
            const Exact::Point_3 b = lifted(face->vertex(1)->point());
            const Exact::Point_3 c = lifted(face->vertex(2)->point());
            keeps ? visit(a, b, c) : visit(a, c, b);
        }
    }

private:
    using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Exact, CGAL::Default,
                                                           CGAL::Exact_intersections_tag>;

    [[nodiscard]] Exact::Point_2 flat(const Exact::Point_3& p) const
    {
        return {p[(down_ + 1) % 3], p[(down_ + 2) % 3]};
    }
    /// Onto the triangle's plane.
    [[nodiscard]] Exact::Point_3 lifted(const Exact::Point_2& p) const
    {
        const Exact::FT u = p.x() - shape_[0][(down_ + 1) % 3];
        const Exact::FT v = p.y() - shape_[0][(down_ + 2) % 3];
        std::array<Exact::FT, 3> q;
        q[(down_ + 1) % 3] = p.x();
        q[(down_ + 2) % 3] = p.y();
        q[down_] = shape_[0][down_] -
                   (normal_[(down_ + 1) % 3] * u + normal_[(down_ + 2) % 3] * v) / normal_[down_];
        return {q[0], q[1], q[2]};
    }

    Exact::Triangle_3 shape_;
    Exact::Vector_3 normal_;
    int down_ = 0;
};

} // namespace

Arrangement arrange(const TriangleMesh& mesh)
{
    Arrangement result;
    PointNumbers numbers(result.points);
    std::vector<std::uint32_t> numberOf;
    std::vector<Fast::Point_3> fast;
    for (const Eigen::Vector3d& v : mesh.vertices)
    {
        const std::uint32_t number = numbers.of(Exact::Point_3(v.x(), v.y(), v.z()));
        numberOf.push_back(number);
        if (number == fast.size())
        {
            fast.emplace_back(v.x(), v.y(), v.z());
        }
    }
    for (const auto& t : mesh.triangles)
    {
        const Corners corners = {numberOf[t[0]], numberOf[t[1]], numberOf[t[2]]};
        if (!CGAL::collinear(fast[corners[0]], fast[corners[1]], fast[corners[2]]))
        {
            result.triangles.push_back(corners);
        }
    }
    result.overlaps.resize(result.triangles.size());
    const Contacts contacts(result, fast);
    for (std::uint32_t i = 0; i < result.triangles.size(); ++i)
    {
        if (contacts.marks[i].none())
        {
            result.parts.push_back({result.triangles[i], i});
            continue;
        }
        Cutter(result.shape(result.triangles[i]))
            .cut(contacts.marks[i],
                 [&](const Exact::Point_3& a, const Exact::Point_3& b, const Exact::Point_3& c) {
                     result.parts.push_back({{numbers.of(a), numbers.of(b), numbers.of(c)}, i});
                 });
    }
    return result;
}

} // namespace frostfill::wrap
