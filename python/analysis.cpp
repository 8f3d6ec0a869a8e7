// SPDX-License-Identifier: MIT
#include "analysis.hpp"

#include "input.hpp"

#include <frostfill/analysis.hpp>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

using Owner = std::shared_ptr<PackingAnalysis>;

Axis axisOf(const py::object& value)
{
    Scene scene;
    const Option& option = optionOf("object.up");
    const std::optional<OptionValue> read = valueOf(option, value);
    if (!read || !setOption(option, scene, *read))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("up is {}, but it must be x, y or z", shown(value)));
    }
    return scene.object.up;
}

AnalysisSettings settingsOf(const py::dict& given)
{
    AnalysisSettings settings;
    settings.up = axisOf(given["up"]);
    if (!given["centre"].is_none())
    {
        const std::vector<double> centre = readNumbers(given["centre"], "centre");
        if (centre.size() != 3)
        {
            throw Error(ErrorCode::usage,
                        fmt::format("centre has {} numbers, but it must have 3", centre.size()));
        }
        settings.centre = Eigen::Vector3d(centre[0], centre[1], centre[2]);
    }
    if (!given["below"].is_none())
    {
        settings.below = numberOf(given["below"], "below");
    }
    if (!given["forces"].is_none())
    {
        settings.forces = numberOf(given["forces"], "forces");
    }
    settings.bins = countOf(given["bins"], "bins");
    settings.range = numberOf(given["range"], "range");
    settings.contactGap = numberOf(given["gap"], "gap");
    settings.bondLength = numberOf(given["bond"], "bond");
    settings.rattlersBelow =
        static_cast<std::uint32_t>(countOf(given["rattlers_below"], "rattlers_below"));
    settings.samples = countOf(given["samples"], "samples");
    settings.threads = static_cast<int>(std::min<std::size_t>(
        countOf(given["threads"], "threads"), std::numeric_limits<std::int16_t>::max()));
    for (const py::handle name : given["only"])
    {
        if (!py::isinstance<py::str>(name))
        {
            throw Error(ErrorCode::usage,
                        fmt::format("only has {}, but it must have names", shown(name)));
        }
        settings.only.push_back(analysisKind(name.cast<std::string>()));
    }
    return settings;
}

Owner analyse(const py::object& centres, const py::object& radii, const py::object& mesh,
              const py::object& vertices, const py::object& triangles, const py::object& box,
              bool periodic, const py::dict& given, const py::kwargs& keywords)
{
    Scene scene;
    GivenKeywords(keywords, OptionUse::loading, "analyse").apply(scene);
    AnalysisSettings settings = settingsOf(given);
    Packing packing;
    packing.centres = readPoints(centres, "centres");
    packing.radii = readRadii(radii, packing.centres.size());
    const GivenContainer container(mesh, vertices, triangles, box, periodic);
    const py::gil_scoped_release release;
    const PackingWalls walls = container.load(scene.object.load);
    settings.bounds = walls.bounds;
    return std::make_shared<PackingAnalysis>(analysePacking(walls.mesh, packing, settings));
}

/// A part of an analysis. Throws Error usage if it was not asked for.
template <class Part>
const Part& partOf(const std::optional<Part>& part, const char* name)
{
    if (!part)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("this analysis has no {0}: leave out only, or name {0} in it{1}",
                                name, hasVoronoiCells() ? "" : "; cells need voro++"));
    }
    return *part;
}

/// A row of `network` in Python.
struct NetworkRow
{
    std::uint32_t first, second;
    double gap;
};

using Class = py::class_<PackingAnalysis, Owner>;

void addSpheres(Class& type)
{
    const auto add = [&](const char* name, auto listOf, const char* help)
    {
        type.def_property_readonly(
            name, [listOf](const Owner& a) { return view(a, listOf(*a)); }, help);
    };
    using A = PackingAnalysis;
    add(
        "ids", [](const A& a) -> auto& { return a.ids; },
        "uint32 [n] place in `centres` of each sphere that counts: not outside, and a number");
    add(
        "centres", [](const A& a) -> auto& { return a.centres; }, "float64 [n, 3]");
    add(
        "radii", [](const A& a) -> auto& { return a.radii; }, "float64 [n]");
    add(
        "wall_distances", [](const A& a) -> auto& { return a.wallDistances; },
        "float64 [n] from the centre to the wall");
    add(
        "depths", [](const A& a) -> auto& { return a.depths; },
        "float64 [n] from the centre up to the surface of the bed");
    const auto contacts = [](const A& a) -> const ContactStatistics&
    { return partOf(a.contacts, "contacts"); };
    add(
        "sphere_contacts", [contacts](const A& a) -> auto& { return contacts(a).spheres; },
        "uint32 [n] other spheres that each touches");
    add(
        "wall_contacts", [contacts](const A& a) -> auto& { return contacts(a).walls; },
        "uint32 [n] pieces of wall that each touches");
    add(
        "rattlers", [contacts](const A& a) -> auto& { return contacts(a).rattler; },
        "uint8 [n] 1 for each that its contacts do not hold");
    const auto cells = [](const A& a) -> const CellStatistics& { return partOf(a.cells, "cells"); };
    add(
        "cells", [cells](const A& a) -> auto& { return cells(a).kinds; },
        "uint8 [n] Voronoi cells: 0 whole, 1 cut by a wall, 2 open, 3 none");
    add(
        "cell_volumes", [cells](const A& a) -> auto& { return cells(a).volumes; },
        "float64 [n] [unit^3] NaN unless whole");
    add(
        "local_fractions", [cells](const A& a) -> auto& { return cells(a).fractions; },
        "float64 [n] share of the cell that the sphere fills; NaN unless whole");
    const auto order = [](const A& a) -> const OrderStatistics&
    { return partOf(a.order, "order"); };
    add(
        "bonds", [order](const A& a) -> auto& { return order(a).bonds; },
        "uint32 [n] spheres near enough for Q6");
    add(
        "q6", [order](const A& a) -> auto& { return order(a).q6; }, "float64 [n]");
}

/// The table of the spheres: of each, the columns that were analysed.
py::array spheresTable(const py::object& self)
{
    const auto& a = *self.cast<Owner>();
    py::dict columns;
    const auto add = [&](const char* column, const char* property, bool isThere = true)
    {
        if (isThere)
        {
            columns[column] = self.attr(property);
        }
    };
    add("id", "ids");
    add("centres", "centres");
    add("radius", "radii");
    add("wall_distance", "wall_distances");
    add("depth", "depths");
    add("sphere_contacts", "sphere_contacts", a.contacts.has_value());
    add("wall_contacts", "wall_contacts", a.contacts.has_value());
    add("rattler", "rattlers", a.contacts.has_value());
    add("cell", "cells", a.cells.has_value());
    add("cell_volume", "cell_volumes", a.cells.has_value());
    add("local_fraction", "local_fractions", a.cells.has_value());
    add("bonds", "bonds", a.order.has_value());
    add("q6", "q6", a.order.has_value());
    return namedTable(columns);
}

void addTables(Class& type)
{
    PYBIND11_NUMPY_DTYPE_EX(PorosityBin, from, "from", to, "to", porosity, "porosity", error,
                            "error", objectVolume, "object_volume");
    PYBIND11_NUMPY_DTYPE_EX(SizeBin, from, "from", to, "to", spheres, "spheres", meanRadius,
                            "mean_radius", deviation, "deviation");
    PYBIND11_NUMPY_DTYPE(PairBin, from, to, g, neighbours);
    PYBIND11_NUMPY_DTYPE(NetworkRow, first, second, gap);
    type.def_property_readonly("table", &spheresTable,
                               "structured array [n] of id, x, y, z, radius, ... of each sphere: "
                               "pandas.DataFrame takes it as it is");
    const auto porosity = [&](const char* name, std::vector<PorosityBin> PorosityProfiles::*profile)
    {
        type.def_property_readonly(
            name,
            [profile](const Owner& a) { return view(a, partOf(a->porosity, "porosity").*profile); },
            "structured array of from, to, porosity, error (its standard error), object_volume "
            "(there)");
    };
    porosity("porosity_height", &PorosityProfiles::height);
    porosity("porosity_radial", &PorosityProfiles::radial);
    porosity("porosity_wall", &PorosityProfiles::wall);
    const auto sizes = [&](const char* name, std::vector<SizeBin> SizeProfiles::*profile)
    {
        type.def_property_readonly(
            name, [profile](const Owner& a) { return view(a, partOf(a->sizes, "sizes").*profile); },
            "structured array of from, to, spheres, mean_radius, deviation (of the radii)");
    };
    sizes("sizes_height", &SizeProfiles::height);
    sizes("sizes_radial", &SizeProfiles::radial);
    type.def_property_readonly(
        "pairs", [](const Owner& a) { return view(a, partOf(a->pairs, "pairs").bins); },
        "structured array of from, to, g, neighbours (up to `to`)");
    type.def_property_readonly(
        "network",
        [](const PackingAnalysis& a)
        {
            const auto& network = partOf(a.contacts, "contacts").network;
            py::array_t<NetworkRow> rows(static_cast<py::ssize_t>(network.size()));
            std::transform(network.begin(), network.end(), rows.mutable_data(),
                           [](const SphereContact& contact) {
                               return NetworkRow{contact.first, contact.second, contact.gap};
                           });
            return rows;
        },
        "structured array [contacts] of first, second (rows of the two spheres in the lists) and "
        "gap");
    type.def_property_readonly(
        "forces",
        [](const PackingAnalysis& a)
        {
            const auto& network = partOf(a.contacts, "contacts").network;
            py::array_t<double> forces({network.size(), std::size_t{3}});
            for (std::size_t k = 0; k < network.size(); ++k)
            {
                std::copy_n(network[k].force.data(), 3, forces.mutable_data(k, 0));
            }
            return forces;
        },
        "float64 [contacts, 3] [weight of a mean sphere] on the first sphere of each row of "
        "network, if forces were asked for; what they leave is summary's largest_unbalance");
}

std::vector<std::string> save(const Owner& analysis, const py::object& folder, bool overwrite)
{
    const std::filesystem::path path = pathOf(folder, "folder");
    const py::gil_scoped_release release;
    if (!overwrite)
    {
        refuseToReplaceAnalysis(path, "pass overwrite=True, or another folder");
    }
    return writeAnalysis(*analysis, path);
}

} // namespace

void addAnalysis(py::module_& module)
{
    Class type(module, "PackingAnalysis", "What frostfill.analyse found.");
    addSpheres(type);
    addTables(type);
    type.def_property_readonly(
        "summary",
        [](const PackingAnalysis& a) -> py::dict
        { return py::module_::import("json").attr("loads")(analysisSummary(a)); },
        "what summary.json holds: means, counts and settings");
    type.def("__repr__", [](const PackingAnalysis& a)
             { return fmt::format("<frostfill.PackingAnalysis of {} spheres>", a.ids.size()); });
    type.def("__str__", &analysisSummary, "What summary.json holds, as text.");
    type.def("save", &save, py::arg("folder"), py::arg("overwrite") = false,
             "Writes the tables, the files for ParaView and summary.json into a folder, as the "
             "command does, and returns their names.");
    module.def("analyse", &analyse);
}

} // namespace frostfill::python
