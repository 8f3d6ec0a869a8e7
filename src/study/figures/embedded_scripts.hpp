// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// gnuplot scripts that the build compiles into the library; see CMakeLists.txt.
namespace frostfill::embedded
{

std::string_view figure_style();
std::string_view figure_claim();
std::string_view figure_operations();
std::string_view figure_closed_forms();
std::string_view figure_error();
std::string_view figure_peers();
std::string_view figure_stability();
std::string_view figure_times();
std::string_view figure_discarded();
std::string_view figure_density();
std::string_view figure_volume();
std::string_view figure_interaction();
std::string_view figure_filling();
std::string_view figure_cutaways();

} // namespace frostfill::embedded
