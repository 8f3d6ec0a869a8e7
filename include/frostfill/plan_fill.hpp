// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/fill.hpp>

#pragma GCC visibility push(default)
namespace frostfill
{

/// Does everything that `fill` does before its first step, but writes nothing: reads and checks
/// scene, mesh and radius, looks whether the directory may be written to, and
/// makes a trial run if it has frames. Throws Error as fill would.
[[nodiscard]] FillPlan planFill(const FillRequest& request, const FillObserver& observer = {});

} // namespace frostfill
#pragma GCC visibility pop
