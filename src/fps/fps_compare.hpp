// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace frostfill
{

/// One quantity of two measurements.
struct FpsChange
{
    std::string object;
    std::string search;
    std::string quantity;
    double before = 0; ///< [ms] mean of the fastest run, which disturbances have added least to
    double now = 0;
    bool regressed = false;

    [[nodiscard]] double percent() const { return before > 0 ? 100 * (now / before - 1) : 0; }
};

struct FpsComparison
{
    std::vector<FpsChange> changes;
    bool sameMachine = true;
    [[nodiscard]] bool regressed() const;
};

/// Compares two documents of fpsJson. Something has regressed when it takes more than `threshold`
/// per cent longer. `name` is that of the older one in messages. Throws Error badData when it is no
/// such document, or has nothing in common with the newer one.
[[nodiscard]] FpsComparison compareFps(const nlohmann::ordered_json& before,
                                       const nlohmann::ordered_json& now, double threshold,
                                       const std::string& name);

} // namespace frostfill
