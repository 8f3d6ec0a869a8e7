// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

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

} // namespace frostfill
