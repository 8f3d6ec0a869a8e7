// SPDX-License-Identifier: MIT
#include "instruments.hpp"

#include "input.hpp"
#include "interrupts.hpp"

#include <frostfill/packing.hpp>
#include <frostfill/volume_estimate.hpp>

#include <fmt/format.h>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

QualityReport check(const py::object& centres, const py::object& radii, const py::object& mesh,
                    const py::object& vertices, const py::object& triangles, const py::object& box,
                    bool periodic, const py::object& atRest, const py::kwargs& keywords)
{
    Scene scene;
    GivenKeywords(keywords, OptionUse::judging, "check").apply(scene);
    Packing packing;
    packing.centres = readPoints(centres, "centres");
    packing.radii = readRadii(radii, packing.centres.size());
    packing.atRest.assign(packing.centres.size(), true);
    if (!atRest.is_none())
    {
        const auto flags = py::array_t<bool, py::array::c_style>::ensure(atRest);
        if (!flags || flags.ndim() != 1 ||
            flags.size() != static_cast<py::ssize_t>(packing.centres.size()))
        {
            PyErr_Clear();
            throw Error(ErrorCode::usage,
                        "at_rest must be an array of bool with one entry for each sphere");
        }
        packing.atRest.assign(flags.data(), flags.data() + flags.size());
    }
    const GivenContainer container(mesh, vertices, triangles, box, periodic);
    const py::gil_scoped_release release;
    return judgePacking(container.load(scene.object.load), packing, scene.object.up, scene.judge);
}

/// Centres, radii, whether each is at rest, and what the file is.
py::tuple readPackingFile(const py::object& path, double radius, const std::string& columns)
{
    const std::filesystem::path file = pathOf(path, "path");
    const auto packing = std::make_shared<Packing>();
    {
        const py::gil_scoped_release release;
        *packing = readPacking(
            file, {.radius = radius,
                   .columns = columns.empty() ? PackingColumns{} : parsePackingColumns(columns)});
    }
    py::array_t<bool> atRest(static_cast<py::ssize_t>(packing->atRest.size()));
    std::copy(packing->atRest.begin(), packing->atRest.end(), atRest.mutable_data());
    return py::make_tuple(view(packing, packing->centres), view(packing, packing->radii), atRest,
                          packing->format);
}

/// The mesh as it is read and as it is filled, and the repairs between.
py::tuple inspect(const py::object& mesh, const py::object& vertices, const py::object& triangles,
                  const py::kwargs& keywords)
{
    Scene scene;
    GivenKeywords(keywords, OptionUse::loading, "inspect").apply(scene);
    const GivenMesh given = readGivenMesh(mesh, vertices, triangles);
    MeshReport asRead;
    MeshReport filled;
    std::vector<std::string> repairs;
    std::optional<Error> refused;
    {
        const py::gil_scoped_release release;
        const TriangleMesh read = given.mesh                  ? *given.mesh
                                  : isBuiltInMesh(given.name) ? builtInMesh(given.name)
                                                              : readMeshSandboxed(given.name);
        asRead = inspectMesh(read);
        if (asRead.closed())
        {
            asRead = inspectInterior(read);
        }
        try
        {
            const LoadedMesh loaded = repairMesh(read, given.name, scene.object.load);
            filled = inspectInterior(loaded.mesh);
            repairs = loaded.repairs;
        }
        catch (const Error& error)
        {
            refused = error;
        }
    }
    if (refused)
    {
        return py::make_tuple(asRead, py::none(), repairs, std::string(refused->what()));
    }
    return py::make_tuple(asRead, filled, repairs, py::none());
}

VolumeEstimate volume(const py::object& mesh, const py::object& vertices,
                      const py::object& triangles, const py::kwargs& keywords)
{
    const GivenKeywords given(keywords, OptionUse::filling, "volume");
    const GivenMesh object = readGivenMesh(mesh, vertices, triangles);
    Scene scene = given.sceneFor(object.name);
    if (scene.preset == Preset::fast && !given.contains("motion.mode"))
    {
        scene.motion.mode = Motion::descend; // nothing is drawn, so the fastest is enough
    }
    given.warnOfIgnored(scene.preset);
    Interrupts interrupts;
    try
    {
        const py::gil_scoped_release release;
        return estimateVolume(scene, object.load(scene.object.load), interrupts.stopRequested());
    }
    catch (const Error&)
    {
        interrupts.throwIfHappened();
        throw;
    }
}

} // namespace

void addInstruments(py::module_& module)
{
    module.def("check", &check);
    module.def("read_packing", &readPackingFile);
    module.def("inspect", &inspect);
    module.def("volume", &volume);
}

} // namespace frostfill::python
