// SPDX-License-Identifier: MIT
#include "render/context/gl.hpp"

#include "render/context/context.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

#include <cctype>
#include <string>
#include <type_traits>

namespace frostfill
{

GlFunctions loadGlFunctions(const Context& context)
{
    GlFunctions gl;
    const auto load = [&](std::string name)
    {
        // The member `clear` is glClear.
        name.front() = static_cast<char>(std::toupper(name.front()));
        name.insert(0, "gl");
        const GlProcedure procedure = context.procedure(name.c_str());
        if (procedure == nullptr)
        {
            throw Error(ErrorCode::noOpenGl,
                        fmt::format("{}: the OpenGL library has no {}", context.name(), name));
        }
        return procedure;
    };
#define FROSTFILL_GL_LOAD(member, type)                                                            \
    gl.member = reinterpret_cast<std::add_pointer_t<type>>(load(#member));
    FROSTFILL_GL_FUNCTIONS(FROSTFILL_GL_LOAD)
#undef FROSTFILL_GL_LOAD
    return gl;
}

} // namespace frostfill
