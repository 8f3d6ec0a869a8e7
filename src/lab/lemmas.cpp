// SPDX-License-Identifier: MIT
#include "lab/lemmas.hpp"

namespace frostfill
{

Operations bruteForce(std::uint64_t spheres)
{
    const std::uint64_t ordered = spheres > 0 ? spheres * (spheres - 1) : 0;
    return {ordered / 2, ordered};
}

Operations lemma1(std::uint64_t beta, std::uint64_t gamma, std::uint64_t alpha)
{
    return lemma2(beta, gamma, 1, alpha);
}

Operations lemma2(std::uint64_t beta, std::uint64_t gamma, std::uint64_t k, std::uint64_t alpha)
{
    const std::uint64_t running = k * gamma;
    const std::uint64_t withFrozen = (beta - k - alpha) * gamma * running;
    const Operations among = bruteForce(running);
    return {withFrozen + among.tests, withFrozen + among.responses};
}

Operations lemma3(std::uint64_t gamma, std::uint64_t k, std::uint64_t m,
                  std::span<const std::uint64_t> discardedAfter)
{
    std::uint64_t left = m;
    std::uint64_t tests = 0;
    for (const std::uint64_t discarded : discardedAfter)
    {
        tests += k * gamma * left;
        left -= discarded;
    }
    return {tests, tests};
}

} // namespace frostfill
