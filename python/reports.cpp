// SPDX-License-Identifier: MIT
#include "reports.hpp"

#include <frostfill/simulation.hpp>
#include <frostfill/volume_estimate.hpp>

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

/// "<frostfill.NAME a=1 b=2>"
template <class T>
void addText(py::class_<T>& report)
{
    report.def("__repr__",
               [](const py::object& self)
               {
                   const py::type type = py::type::of(self);
                   std::string text =
                       fmt::format("<frostfill.{}", std::string(py::str(type.attr("__name__"))));
                   for (const auto& [name, value] : py::dict(type.attr("__dict__")))
                   {
                       if (PyObject_HasAttrString(value.ptr(), "fget") == 1)
                       {
                           text += fmt::format(" {}={}", std::string(py::str(name)),
                                               std::string(py::str(self.attr(name))));
                       }
                   }
                   return text + ">";
               });
}

void addQuality(py::module_& module)
{
    py::class_<QualityReport> report(
        module, "QualityReport",
        "The quality of a packing. Overlaps are depths over the radius, the smaller of two.");
    const auto add = [&](const char* name, auto member, const char* help)
    { report.def_readonly(name, member, help); };
    using R = QualityReport;
    add("max_overlap", &R::maxOverlap, "[r] the largest overlap of two spheres");
    add("mean_overlap", &R::meanOverlap, "[r] over all pairs that touch or overlap");
    add("max_wall_overlap", &R::maxWallOverlap, "[r] the largest overlap of sphere and mesh");
    add("centres_outside", &R::centresOutside, "by winding number");
    add("not_finite", &R::notFinite, "spheres whose position is not a number");
    add("unsupported", &R::unsupported, "spheres at rest whose contacts cannot carry their weight");
    add("energy_gain", &R::energyGain,
        "largest growth of the total energy in a step, over that of a fall; 0 without a run");
    add("energy_excess", &R::energyExcess,
        "largest excess of the energy over its start plus the work done, over that of a fall; 0 "
        "without a run");
    add("mesh_volume", &R::meshVolume, "[unit^3]");
    add("sphere_volume", &R::sphereVolume, "[unit^3] of all spheres");
    add("volume_estimate", &R::volumeEstimate,
        "[unit^3] of the mesh, estimated from the number of spheres; NaN unless full of equal "
        "ones");
    add("volume_estimate_error", &R::volumeEstimateError, "[unit^3] its uncertainty");
    add("equilibrium", &R::equilibrium,
        "whether all that is at rest stays so together; None unless judge_friction is given");
    add("heaps", &R::heaps, "the heap below each inlet");
    add("settling", &R::settling, "how all settled together; None unless rest is joint");
    addText(report);
}

void addSettling(py::module_& module)
{
    py::class_<SettlingReport> report(module, "SettlingReport",
                                      "How all spheres have settled together.");
    const auto add = [&](const char* name, auto member, const char* help)
    { report.def_readonly(name, member, help); };
    using R = SettlingReport;
    add("rounds", &R::rounds, "times that all have settled; the object is filled up in between");
    add("settled", &R::settled, "False: some still moved when they were frozen");
    add("missing", &R::missing, "[own weight] that forces miss on a sphere in the end, at most");
    add("overlap", &R::overlap, "[radius] that was left, at most");
    add("fraction", &R::fraction,
        "packing fraction of the bulk; None unless fraction asks for one");
    addText(report);
}

void addHeap(py::module_& module)
{
    py::class_<HeapReport> report(module, "HeapReport", "The heap below an inlet.");
    report.def_readonly("spheres", &HeapReport::spheres, "at rest, nearest to this inlet");
    report.def_readonly("slope", &HeapReport::slope,
                        "[degree] of its free surface; None for a heap of a few radii");
    addText(report);
}

void addSizes(py::module_& module)
{
    using Point = SizePoint;
    py::class_<Point> point(
        module, "SizePoint",
        "What share of all spheres is no larger than a radius, as it was asked for and as it is.");
    point.def_readonly("radius", &Point::radius, "[unit]");
    point.def_readonly("asked", &Point::asked, "[1] of the mass");
    point.def_readonly("achieved", &Point::achieved, "[1] of the mass");
    point.def_readonly("asked_number", &Point::askedNumber, "[1] of the number");
    point.def_readonly("achieved_number", &Point::achievedNumber, "[1] of the number");
    addText(point);
    using R = SizeReport;
    py::class_<R> report(module, "SizeReport",
                         "The size curve of a run beside the one that was asked for.");
    report.def_readonly("points", &R::points, "at ascending radii");
    report.def_readonly("deviation", &R::deviation,
                        "[1] of the mass, the largest at any of the points");
    report.def_readonly("at", &R::at, "[unit] the radius of that point");
    addText(report);
}

void addEquilibrium(py::module_& module)
{
    py::class_<EquilibriumReport> report(
        module, "EquilibriumReport",
        "Whether forces in all contacts at once balance all spheres at rest, under a friction.");
    const auto add = [&](const char* name, auto member, const char* help)
    { report.def_readonly(name, member, help); };
    using R = EquilibriumReport;
    add("friction", &R::friction, "under which it was judged");
    add("spheres", &R::spheres, "at rest");
    add("unbalanced", &R::unbalanced,
        "spheres that miss more than judge_unbalance of their weight");
    add("largest", &R::largest, "[own weight] what is missing on a sphere at most");
    add("settled", &R::settled, "False: forces were still changing when they were taken");
    add("least_friction", &R::leastFriction,
        "with which all but one in a hundred are balanced; inf: none up to 8");
    addText(report);
}

void addMeshReport(py::module_& module)
{
    py::class_<MeshReport> report(module, "MeshReport", "Facts about a mesh. Counts are exact.");
    const auto add = [&](const char* name, auto member, const char* help)
    { report.def_readonly(name, member, help); };
    using R = MeshReport;
    add("vertices", &R::vertices, "number of vertices");
    add("triangles", &R::triangles, "number of triangles");
    add("components", &R::components, "pieces connected through shared edges");
    add("boundary_edges", &R::boundaryEdges, "edges with one triangle: the rim of a hole");
    add("non_manifold_edges", &R::nonManifoldEdges, "edges with three triangles or more");
    add("unbalanced_edges", &R::unbalancedEdges, "those of them whose windings do not cancel");
    add("inconsistent_edges", &R::inconsistentEdges,
        "edges whose two triangles have opposite windings");
    add("degenerate_triangles", &R::degenerateTriangles, "triangles without area");
    add("duplicate_triangles", &R::duplicateTriangles, "triangles that are there twice");
    add("unused_vertices", &R::unusedVertices, "vertices without a triangle");
    add("genus", &R::genus, "handles over all components; of a closed mesh");
    add("volume", &R::volume, "[unit^3] of the interior; of an open mesh a signed sum");
    add("area", &R::area, "[unit^2]");
    add("crossed_triangles", &R::crossedTriangles,
        "triangles that meet others away from their edges");
    report
        .def_property_readonly(
            "box", [](const R& r) { return py::make_tuple(r.box.min(), r.box.max()); },
            "the lowest and the highest corner of the mesh's box, each float64 [3]")
        .def_property_readonly("closed", &R::closed, "whether the windings at every edge cancel");
    addText(report);
}

void addVolume(py::module_& module)
{
    py::class_<VolumeEstimate> report(module, "VolumeEstimate",
                                      "An object's volume, estimated from fillings with spheres.");
    const auto add = [&](const char* name, auto member, const char* help)
    { report.def_readonly(name, member, help); };
    using R = VolumeEstimate;
    add("volume", &R::volume, "[unit^3] the estimate");
    add("error", &R::error, "[unit^3] its uncertainty");
    add("mesh_volume", &R::meshVolume, "[unit^3] of the mesh itself, to compare with");
    add("radius", &R::radius, "[unit] of the coarse spheres; the fine ones have half of it");
    add("coarse", &R::coarse, "spheres of the radius that fit, a mean over seeds");
    add("fine", &R::fine, "spheres of half the radius that fit");
    addText(report);
}

} // namespace

void addReports(py::module_& module)
{
    addHeap(module);
    addSizes(module);
    addEquilibrium(module);
    addSettling(module);
    addQuality(module);
    addMeshReport(module);
    addVolume(module);
}

} // namespace frostfill::python
