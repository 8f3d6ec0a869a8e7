// SPDX-License-Identifier: MIT
#pragma once

#include "fps/table.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace frostfill
{

/// Pairs examined and spheres corrected.
struct Operations
{
    std::uint64_t tests = 0;
    std::uint64_t responses = 0; ///< when every tested pair collides
    [[nodiscard]] std::uint64_t sum() const { return tests + responses; }
};

/// PAPER, section 1.1: all n spheres running. n(n-1)/2 tests, n(n-1) responses.
[[nodiscard]] Operations bruteForce(std::uint64_t spheres);

/// PAPER, Lemma 1: `beta` groups of `gamma` spheres, the last one running, `alpha` of the others
/// discarded. One step: (beta - alpha - 1) gamma^2 tests with frozen spheres, gamma (gamma - 1) / 2
/// among the running ones. The leading order of the sum is (2 (beta - alpha) - 1/2) gamma^2: what
/// the paper prints as "2 beta - 1/2 gamma^2" once its bracket is put back.
[[nodiscard]] Operations lemma1(std::uint64_t beta, std::uint64_t gamma, std::uint64_t alpha);

/// PAPER, Lemma 2: sets of `k` groups, the last set running; `alpha` counts discarded groups, which
/// need not make whole sets. The number of earlier sets is beta/k - 1 (the paper prints beta - k,
/// which its own example contradicts). `beta` is a multiple of k.
[[nodiscard]] Operations lemma2(std::uint64_t beta, std::uint64_t gamma, std::uint64_t k,
                                std::uint64_t alpha);

/// PAPER, Lemma 3: one step of each set with `m` polygons, of which `discardedAfter[t]` were
/// discarded after set t: the sum over the sets s of k gamma (m - those of all t < s).
[[nodiscard]] Operations lemma3(std::uint64_t gamma, std::uint64_t k, std::uint64_t m,
                                std::span<const std::uint64_t> discardedAfter);

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
