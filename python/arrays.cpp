// SPDX-License-Identifier: MIT
#include "arrays.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <limits>
#include <string>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

/// Ten times as many as fit into any run. NumPy can describe more than any memory holds.
constexpr py::ssize_t kMaxRows = 300'000'000;

[[noreturn]] void refuse(const char* name, const std::string& fault, const char* wanted)
{
    throw Error(ErrorCode::usage, fmt::format("{} {}, but must be {}", name, fault, wanted));
}

std::string shapeText(const py::array& array)
{
    return py::str(array.attr("shape"));
}

py::array arrayOf(py::handle value, const char* name, const char* kinds, const char* wanted)
{
    py::array array = value.is_none() ? py::array() : py::array::ensure(value);
    if (value.is_none() || !array)
    {
        PyErr_Clear();
        refuse(name, value.is_none() ? "is not given" : "is no array", wanted);
    }
    if (array.size() > 0 &&
        std::string_view(kinds).find(array.dtype().kind()) == std::string_view::npos)
    {
        refuse(name, fmt::format("has the type {}", std::string(py::str(array.dtype()))), wanted);
    }
    if (array.ndim() > 0 && array.shape(0) > kMaxRows)
    {
        refuse(name, fmt::format("has {} rows", array.shape(0)), "shorter: at most 300,000,000");
    }
    return array;
}

template <class T>
py::array_t<T, py::array::c_style | py::array::forcecast>
converted(const py::array& array, const char* name, const char* wanted)
{
    auto numbers = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(array);
    if (!numbers)
    {
        PyErr_Clear();
        refuse(name, "cannot be converted", wanted);
    }
    return numbers;
}

void requireRowsOfThree(const py::array& array, const char* name, const char* wanted)
{
    if (array.ndim() != 2 || array.shape(1) != 3)
    {
        refuse(name, fmt::format("has the shape {}", shapeText(array)), wanted);
    }
}

} // namespace

std::vector<Eigen::Vector3d> readPoints(py::handle value, const char* name)
{
    constexpr const char* kWanted = "an array of numbers of shape (n, 3)";
    const py::array array = arrayOf(value, name, "fiu", kWanted);
    requireRowsOfThree(array, name, kWanted);
    const auto numbers = converted<double>(array, name, kWanted);
    std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(numbers.shape(0)));
    const double* next = numbers.data();
    for (Eigen::Vector3d& point : points)
    {
        point = Eigen::Vector3d(next[0], next[1], next[2]);
        next += 3;
    }
    return points;
}

std::vector<double> readNumbers(py::handle value, const char* name)
{
    constexpr const char* kWanted = "an array of numbers of shape (n,)";
    const py::array array = arrayOf(value, name, "fiu", kWanted);
    if (array.ndim() != 1)
    {
        refuse(name, fmt::format("has the shape {}", shapeText(array)), kWanted);
    }
    const auto numbers = converted<double>(array, name, kWanted);
    return {numbers.data(), numbers.data() + numbers.size()};
}

std::vector<double> readRadii(const py::object& radii, std::size_t count)
{
    py::array array = py::array::ensure(radii);
    PyErr_Clear();
    if (array && array.ndim() == 0 && !radii.is_none())
    {
        return std::vector<double>(count, readNumbers(array.reshape({1}), "radii").front());
    }
    std::vector<double> numbers = readNumbers(radii, "radii");
    if (numbers.size() != count)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("there are {} centres and {} radii: give one radius for each, or "
                                "one number for all",
                                count, numbers.size()));
    }
    return numbers;
}

TriangleMesh readMesh(py::handle vertices, py::handle triangles)
{
    constexpr const char* kWanted = "an array of whole numbers of shape (n, 3)";
    TriangleMesh mesh;
    mesh.vertices = readPoints(vertices, "vertices");
    const py::array array = arrayOf(triangles, "triangles", "iu", kWanted);
    requireRowsOfThree(array, "triangles", kWanted);
    const auto indices = converted<std::int64_t>(array, "triangles", kWanted);
    mesh.triangles.resize(static_cast<std::size_t>(indices.shape(0)));
    const std::int64_t* next = indices.data();
    const auto count = static_cast<std::int64_t>(mesh.vertices.size());
    for (auto& triangle : mesh.triangles)
    {
        for (std::uint32_t& corner : triangle)
        {
            if (*next < 0 || *next >= count)
            {
                refuse("triangles", fmt::format("has the index {}", *next),
                       fmt::format("from 0 to {}, the last of the vertices", count - 1).c_str());
            }
            corner = static_cast<std::uint32_t>(*next++);
        }
    }
    return mesh;
}

py::array namedTable(const py::dict& columns)
{
    py::dict flat;
    for (const auto& [name, column] : columns)
    {
        const auto array = py::cast<py::array>(column);
        for (int axis = 0; axis < 3 && array.ndim() == 2; ++axis)
        {
            flat[py::str(std::string(1, static_cast<char>('x' + axis)))] =
                array[py::make_tuple(py::ellipsis(), axis)];
        }
        if (array.ndim() == 1)
        {
            flat[name] = array;
        }
    }
    py::list fields;
    py::ssize_t rows = 0;
    for (const auto& [name, column] : flat)
    {
        fields.append(py::make_tuple(name, column.attr("dtype")));
        rows = static_cast<py::ssize_t>(py::len(column));
    }
    py::array table(py::dtype::from_args(fields), std::vector<py::ssize_t>{rows});
    for (const auto& [name, column] : flat)
    {
        table[name] = column;
    }
    return table;
}

} // namespace frostfill::python
