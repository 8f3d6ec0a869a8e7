// SPDX-License-Identifier: MIT
#pragma once

#include "fps/table.hpp"
#include "lab/lemmas.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace frostfill
{

/// One way of filling: the paper's method with a freezing after every set, all pairs visited.
struct OperationsCase
{
    std::string object = "torus";
    std::uint64_t gamma = 10;
    std::uint64_t k = 1;
    bool discards = false; ///< the paper's
    std::uint64_t groups = 200;
    /// The radius is that at which so many groups fit; 0: as many as there are. Sets are whole only
    /// while spheres are small enough for all of a set to find room at once.
    std::uint64_t room = 0;
};

/// What was measured while one set ran, and what the lemmas say. A step.
struct OperationsRow
{
    std::uint64_t beta = 0;        ///< groups so far, those that run among them
    std::uint64_t alpha = 0;       ///< groups discarded
    std::uint64_t polygons = 0;    ///< not discarded
    std::uint64_t sphereTests = 0; ///< between spheres, the same at every step of a set
    std::uint64_t greatestSphereResponses = 0;
    double meanSphereResponses = 0;
    std::uint64_t polygonTests = 0;
    std::uint64_t greatestPolygonResponses = 0;
    std::uint64_t polygonTestsSoFar = 0; ///< of one step of each set until now
    Operations spheres;                  ///< Lemma 1 or 2
    Operations polygonsSoFar;            ///< Lemma 3
    Operations withoutFreezing;          ///< all spheres running
    bool constant = true;                ///< the tests were the same at every step of the set

    /// Tests equal the lemmas', and responses stay within them.
    [[nodiscard]] bool agrees() const;
};

struct OperationsResult
{
    OperationsCase what;
    std::uint64_t polygons = 0;      ///< m
    std::vector<OperationsRow> rows; ///< by set
};

/// Throws Error.
[[nodiscard]] OperationsResult measureOperations(const OperationsCase& what);

/// Every row of every result.
[[nodiscard]] Table operationsCsv(const std::vector<OperationsResult>& results);

} // namespace frostfill
