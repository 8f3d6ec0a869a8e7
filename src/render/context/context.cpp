// SPDX-License-Identifier: MIT
#include "render/context/context.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>

namespace frostfill
{

namespace
{

bool answersTo(Backend choice, Backend asked)
{
    return asked == Backend::automatic || asked == choice ||
           (asked == Backend::egl && choice != Backend::osmesa);
}

} // namespace

thread_local Context* Context::current = nullptr;

void Context::makeCurrent()
{
    if (current == this)
    {
        return;
    }
    if (current != nullptr)
    {
        current->wake();
    }
    bind();
    current = this;
}

void Context::wake()
{
    if (current == this)
    {
        unbind();
        current = nullptr;
    }
}

const std::vector<BackendChoice>& backendChoices()
{
    static const std::vector<BackendChoice> choices = {
        {Backend::osmesa, "osmesa", &openOsmesa, "apt install libosmesa6"},
        {Backend::eglHardware, "egl-hardware", &openEglHardware,
         "the graphics card's driver, with its part for EGL"},
        {Backend::eglSoftware, "egl-software", &openEglSoftware,
         "apt install libegl1 libegl-mesa0 libgl1-mesa-dri"},
        {Backend::eglSurfaceless, "egl-surfaceless", &openEglSurfaceless,
         "apt install libegl1 libegl-mesa0 libgl1-mesa-dri"},
    };
    return choices;
}

std::unique_ptr<Context> openContext(Backend backend)
{
    std::string attempts;
    for (const BackendChoice& choice : backendChoices())
    {
        if (!answersTo(choice.backend, backend))
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
    throw Error(ErrorCode::noOpenGl, "no OpenGL context is available:" + attempts);
}

} // namespace frostfill
