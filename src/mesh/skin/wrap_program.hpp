// SPDX-License-Identifier: MIT
// Room: skins and unions. They are made by frostfill-wrap, a separate program under the GPL, which
// is called as a child process; this room only knows how to call it and when that helps.
#pragma once

#include <frostfill/mesh.hpp>

#include <filesystem>
#include <optional>
#include <string_view>

namespace frostfill
{

/// The program that FROSTFILL_WRAP names; else frostfill-wrap beside this program, in ../libexec
/// from there, or in PATH. Nothing if there is none that can be executed.
[[nodiscard]] std::optional<std::filesystem::path> findWrapProgram();

/// A closed surface without crossings around all triangles of a mesh, `offset` away from them. It
/// goes into openings wider than some 2 alpha. All that it encloses is inside, cavities too. Throws
/// Error missingProgram if there is no program, badData if it fails; `name` is used in messages.
[[nodiscard]] TriangleMesh makeSkin(const TriangleMesh& mesh, double alpha, double offset,
                                    std::string_view name);

/// The boundary of a closed mesh's interior, without the walls inside it. Throws as makeSkin does.
[[nodiscard]] TriangleMesh makeUnion(const TriangleMesh& mesh, std::string_view name);

} // namespace frostfill
