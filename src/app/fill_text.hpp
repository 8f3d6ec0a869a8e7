// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/fill.hpp>

namespace frostfill
{

/// What the command fill says before the first step, on standard error.
void printPlan(const FillRequest& request, const FillPlan& plan);

/// What it says at the end, on standard output.
void printResult(const Scene& scene, const FillResult& result);

} // namespace frostfill
