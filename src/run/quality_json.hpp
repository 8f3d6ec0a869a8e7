// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/simulation.hpp>

#include <nlohmann/json.hpp>

namespace frostfill
{

/// What the judge says of any packing, by the names of summary.json. What was not judged is left
/// out, and a number that is infinite is null.
[[nodiscard]] nlohmann::ordered_json qualityJson(const QualityReport& quality);

} // namespace frostfill
