// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The triangles at each vertex, ascending. A triangle that repeats a corner is at none.
class VertexTriangles
{
public:
    explicit VertexTriangles(const TriangleMesh& mesh);

    [[nodiscard]] std::size_t vertices() const { return starts_.size() - 1; }
    [[nodiscard]] std::span<const std::uint32_t> at(std::size_t vertex) const
    {
        return {triangles_.data() + starts_[vertex], starts_[vertex + 1] - starts_[vertex]};
    }

private:
    std::vector<std::uint32_t> starts_; ///< [#V + 1]
    std::vector<std::uint32_t> triangles_;
};

} // namespace frostfill
