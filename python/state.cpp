// SPDX-License-Identifier: MIT
#include "state.hpp"

#include "arrays.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <array>
#include <memory>
#include <string>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

using Pointer = std::shared_ptr<State>;

/// Those of the table, without a copy.
py::array arrayOf(const Pointer& s, const Column& column)
{
    if (column.name == "radius")
    {
        return view(s, s->radii);
    }
    if (column.name == "state")
    {
        return view(s, s->snapshot.states);
    }
    if (column.name == "group")
    {
        return view(s, s->snapshot.groups);
    }
    if (column.name == "speed")
    {
        return view(s, s->snapshot.speeds);
    }
    const ColumnValues* values = s->snapshot.values(column);
    if (values == nullptr)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("the run was kept without the column {}", column.name));
    }
    return column.isWhole() ? view(s, values->bits)
                            : view(s, reinterpret_cast<const float*>(values->bits.data()),
                                   {static_cast<py::ssize_t>(values->bits.size())});
}

void addColumns(py::class_<State, Pointer>& state)
{
    constexpr std::array kTypes = {"uint8", "uint32", "float32", "float64"};
    for (const Column& column : columns())
    {
        if (column.python)
        {
            const std::string help = fmt::format(
                "{} [n]: {}.", kTypes.at(static_cast<std::size_t>(column.type)), column.help);
            state.def_property_readonly(
                column.plural.c_str(), [&column](const Pointer& s) { return arrayOf(s, column); },
                help.c_str());
        }
    }
}

/// Centres and all columns that there are.
py::array tableOf(const Pointer& s)
{
    py::dict columns;
    columns["centres"] = view(s, s->centres);
    for (const Column& column : frostfill::columns())
    {
        const bool kept = !column.isCarried() || s->snapshot.values(column) != nullptr;
        if (column.python && kept)
        {
            columns[column.name.c_str()] = arrayOf(s, column);
        }
    }
    return namedTable(columns);
}

void addArrays(py::class_<State, Pointer>& state)
{
    state.def_property_readonly(
        "table", &tableOf,
        "structured array [n] of x, y, z, radius, state, ...: pandas.DataFrame takes it as it is.");
    state.def_property_readonly(
        "centres", [](const Pointer& s) { return view(s, s->centres); },
        "float64 [n, 3]: centres of the spheres, in the unit and frame of the mesh. Sphere k "
        "is "
        "row k, in order of appearance.");
    addColumns(state);
    state
        .def_property_readonly(
            "triangle_states", [](const Pointer& s) { return view(s, s->snapshot.polygons); },
            "uint8 [t]: 0 active, 1 discarded, of the triangles of the simulated mesh.")
        .def_property_readonly(
            "changed", [](const Pointer& s) { return view(s, s->snapshot.changed); },
            "uint32 [c]: ascending ids of the spheres that appeared, moved or changed their state "
            "since these arrays were last brought up to date. All of them, for the first.")
        .def_property_readonly(
            "rotation",
            [](const Pointer& s)
            {
                // Eigen has columns in a row; NumPy gets the transpose of the transpose.
                return py::object(view(s, s->snapshot.pose.rotation.data(), {3, 3}).attr("T"));
            },
            "float64 [3, 3]: of a moved object. A point p of the mesh is at origin + offset + "
            "rotation @ (p - origin).")
        .def_property_readonly(
            "offset", [](const Pointer& s) { return view(s, s->snapshot.pose.offset.data(), {3}); },
            "float64 [3]: of a moved object, in the unit of the mesh.")
        .def_property_readonly(
            "origin", [](const Pointer& s) { return view(s, s->snapshot.origin.data(), {3}); },
            "float64 [3]: the middle of the mesh's box, in the frame of the mesh.");
}

} // namespace

void addState(py::module_& module)
{
    py::class_<State, Pointer> state(module, "Snapshot", R"(A state of a run: arrays and counts.

Arrays are read-only views of the library's own memory, made without a copy. They stay as they are
for as long as you keep them; a simulation then takes other memory for its next states.)");
    addArrays(state);
    state
        .def_property_readonly(
            "time", [](const State& s) { return s.snapshot.time; }, "Simulated time, in seconds.")
        .def_property_readonly(
            "step", [](const State& s) { return s.snapshot.step; },
            "Number of time steps since the start.")
        .def_property_readonly(
            "frame", [](const State& s) { return s.frame; },
            "Number of the frame in a run that was kept; 0 in a simulation.")
        .def_property_readonly(
            "set", [](const State& s) { return s.snapshot.set; }, "Index of the newest set.")
        .def_property_readonly(
            "running", [](const State& s) { return s.snapshot.running; },
            "Number of running spheres.")
        .def_property_readonly(
            "frozen", [](const State& s) { return s.snapshot.frozen; }, "Number of frozen spheres.")
        .def_property_readonly(
            "discarded", [](const State& s) { return s.snapshot.discarded; },
            "Number of discarded spheres.")
        .def_property_readonly(
            "discarded_triangles", [](const State& s) { return s.snapshot.discardedPolygons; },
            "Number of discarded triangles.")
        .def("__len__", [](const State& s) { return s.centres.size(); })
        .def("__repr__",
             [](const State& s)
             {
                 return fmt::format("<frostfill.Snapshot of {} spheres at {:.6g} s: {} running, {} "
                                    "frozen, {} discarded>",
                                    s.centres.size(), s.snapshot.time, s.snapshot.running,
                                    s.snapshot.frozen, s.snapshot.discarded);
             });
}

} // namespace frostfill::python
