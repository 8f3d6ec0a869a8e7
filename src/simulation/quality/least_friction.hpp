// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/quality/contact_network.hpp"

#include <cstddef>

namespace frostfill
{

/// The least friction with which all but `except` bodies miss at most `unbalance` of their weight,
/// to kFrictionStep of itself or kLeastFriction; infinite when none up to
/// JudgeSettings::kMostFriction will do. By bisection.
[[nodiscard]] double leastFriction(const ContactNetwork& network, double unbalance,
                                   std::size_t except, Threads& threads);

} // namespace frostfill
