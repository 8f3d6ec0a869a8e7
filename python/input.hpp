// SPDX-License-Identifier: MIT
#pragma once

#include "arrays.hpp"
#include "keywords.hpp"
#include "values.hpp"

#include <frostfill/analysis.hpp>
#include <frostfill/error.hpp>

#include <atomic>
#include <optional>
#include <string>

namespace frostfill::python
{

/// A mesh as a call gives it: a built-in name or a file, or two arrays.
struct GivenMesh
{
    std::string name;
    std::optional<TriangleMesh> mesh = {};

    /// Loads or repairs it. Needs no interpreter.
    [[nodiscard]] LoadedMesh load(const LoadMeshOptions& options) const
    {
        return mesh ? repairMesh(*mesh, name, options) : loadMesh(name, options);
    }
};

/// A mesh by its name or file, or by a list of files, which are patches of it.
[[nodiscard]] inline std::string meshNameOf(pybind11::handle mesh)
{
    const bool several = PyList_Check(mesh.ptr()) != 0 || PyTuple_Check(mesh.ptr()) != 0;
    if (!several || pybind11::len(mesh) == 0)
    {
        return pathOf(mesh, "mesh");
    }
    std::string name;
    for (const pybind11::handle part : pybind11::list(mesh.cast<pybind11::object>()))
    {
        name += (name.empty() ? "" : "+") + pathOf(part, "mesh");
    }
    return name;
}

/// Reads one of `mesh` and the pair of arrays; the others are None. Throws Error usage.
[[nodiscard]] inline GivenMesh readGivenMesh(pybind11::handle mesh, pybind11::handle vertices,
                                             pybind11::handle triangles)
{
    const bool arrays = !vertices.is_none() || !triangles.is_none();
    if (mesh.is_none() == !arrays)
    {
        throw Error(ErrorCode::usage, "give a mesh, by name or file, or vertices and triangles");
    }
    return arrays ? GivenMesh{"arrays", readMesh(vertices, triangles)}
                  : GivenMesh{meshNameOf(mesh)};
}

/// The container of a packing: a mesh, or a box.
class GivenContainer
{
public:
    /// Throws Error usage unless there is one of them.
    GivenContainer(pybind11::handle mesh, pybind11::handle vertices, pybind11::handle triangles,
                   const pybind11::object& box, bool periodic)
    {
        if (box.is_none() && periodic)
        {
            throw Error(ErrorCode::usage, "periodic needs a box");
        }
        const bool hasMesh = !mesh.is_none() || !vertices.is_none() || !triangles.is_none();
        if (!box.is_none() && hasMesh)
        {
            throw Error(ErrorCode::usage, "give a mesh or a box, not both");
        }
        if (box.is_none())
        {
            mesh_ = readGivenMesh(mesh, vertices, triangles);
            return;
        }
        box_ = wallsOfBox(readNumbers(box, "box"), periodic);
    }

    /// Loads or repairs the mesh. Needs no interpreter.
    [[nodiscard]] PackingWalls load(const LoadMeshOptions& options) const
    {
        return box_ ? *box_ : PackingWalls{mesh_.load(options).mesh};
    }

private:
    GivenMesh mesh_;
    std::optional<PackingWalls> box_;
};

/// Keeps a second thread out of what the first one uses without holding the interpreter.
class ExclusiveUse
{
public:
    explicit ExclusiveUse(std::atomic<bool>& flag) : flag_(flag)
    {
        if (flag_.exchange(true))
        {
            throw Error(ErrorCode::usage, "another thread is using this object: take turns, or "
                                          "give each thread its own");
        }
    }
    ~ExclusiveUse() { flag_ = false; }
    ExclusiveUse(const ExclusiveUse&) = delete;
    ExclusiveUse& operator=(const ExclusiveUse&) = delete;

private:
    std::atomic<bool>& flag_;
};

} // namespace frostfill::python
