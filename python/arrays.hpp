// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <pybind11/numpy.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace frostfill::python
{

/// Numbers of a call as the library has them: a copy of what NumPy makes of a list, an array of any
/// layout and any type of number. `name` is for messages. Throw Error usage for anything else.
[[nodiscard]] std::vector<Eigen::Vector3d> readPoints(pybind11::handle value, const char* name);
[[nodiscard]] std::vector<double> readNumbers(pybind11::handle value, const char* name);
/// One radius for all spheres, or one each.
[[nodiscard]] std::vector<double> readRadii(const pybind11::object& radii, std::size_t count);
/// [#V x 3] and [#T x 3]. Throws Error usage for an index without a vertex as well.
[[nodiscard]] TriangleMesh readMesh(pybind11::handle vertices, pybind11::handle triangles);

/// A structured array with these columns, which pandas takes as it is: by name an array of [n], or
/// of [n, 3], which becomes x, y and z.
[[nodiscard]] pybind11::array namedTable(const pybind11::dict& columns);

/// A read-only array of `data` without a copy. It keeps the owner, and so the data, alive.
template <class T, class Owner>
pybind11::array view(const std::shared_ptr<Owner>& owner, const T* data,
                     std::vector<pybind11::ssize_t> shape)
{
    // NumPy knows no enumerations.
    using Number = typename std::conditional_t<std::is_enum_v<T>, std::underlying_type<T>,
                                               std::type_identity<T>>::type;
    auto kept = std::make_unique<std::shared_ptr<Owner>>(owner);
    const pybind11::capsule base(kept.get(), [](void* pointer)
                                 { delete static_cast<std::shared_ptr<Owner>*>(pointer); });
    kept.release(); // the capsule's now
    pybind11::array_t<Number> array(std::move(shape), reinterpret_cast<const Number*>(data), base);
    array.attr("flags").attr("writeable") = false;
    return array;
}

template <class T, class Owner>
pybind11::array view(const std::shared_ptr<Owner>& owner, const std::vector<T>& values)
{
    return view(owner, values.data(), {static_cast<pybind11::ssize_t>(values.size())});
}

/// [#V x 3]
template <class Scalar, class Owner>
pybind11::array view(const std::shared_ptr<Owner>& owner,
                     const std::vector<Eigen::Matrix<Scalar, 3, 1>>& points)
{
    static_assert(sizeof(points[0]) == 3 * sizeof(Scalar));
    return view(owner, reinterpret_cast<const Scalar*>(points.data()),
                {static_cast<pybind11::ssize_t>(points.size()), 3});
}

} // namespace frostfill::python
