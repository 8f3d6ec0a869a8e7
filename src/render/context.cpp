// SPDX-License-Identifier: MIT
#include "context.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

namespace frostfill
{

const std::vector<BackendChoice>& backendChoices()
{
    static const std::vector<BackendChoice> choices = {
        {Backend::osmesa, "osmesa", &openOsmesa, "apt install libosmesa6"},
    };
    return choices;
}

std::unique_ptr<Context> openContext(Backend backend)
{
    std::string attempts;
    for (const BackendChoice& choice : backendChoices())
    {
        if (backend != Backend::automatic && backend != choice.backend)
        {
            continue;
        }
        try
        {
            return choice.open();
        }
        catch (const Error& error)
        {
            attempts += fmt::format("\n  {} (to install it: {})", error.what(), choice.remedy);
        }
    }
    throw Error(ErrorCode::noOpenGl, "no OpenGL context is to be had:" + attempts);
}

} // namespace frostfill
