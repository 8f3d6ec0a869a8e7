// SPDX-License-Identifier: MIT
#pragma once

#include "arrays.hpp"
#include "keywords.hpp"
#include "values.hpp"

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
                  : GivenMesh{pathOf(mesh, "mesh")};
}

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
