// SPDX-License-Identifier: MIT
#include "render/context/gl.hpp"

#include "render/context/context.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

namespace frostfill
{

GlFunctions loadGlFunctions(const Context& context)
{
    GlFunctions gl;
    const auto load = [&](const char* name)
    {
        const GlProcedure procedure = context.procedure(name);
        if (procedure == nullptr)
        {
            throw Error(ErrorCode::noOpenGl,
                        fmt::format("{}: the OpenGL library has no {}", context.name(), name));
        }
        return procedure;
    };
#define FROSTFILL_GL_LOAD(member, type, name) gl.member = reinterpret_cast<type>(load(name));
    FROSTFILL_GL_FUNCTIONS(FROSTFILL_GL_LOAD)
#undef FROSTFILL_GL_LOAD
    return gl;
}

} // namespace frostfill
