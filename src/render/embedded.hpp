// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// Files that the build compiles into the library; see CMakeLists.txt.
namespace frostfill::embedded
{

std::string_view fontDejaVuSans();
std::string_view shader_common_glsl();
std::string_view shader_sphere_vert();
std::string_view shader_sphere_frag();
std::string_view shader_surface_frag();
std::string_view shader_mesh_vert();
std::string_view shader_mesh_frag();

} // namespace frostfill::embedded
