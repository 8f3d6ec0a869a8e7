// SPDX-License-Identifier: MIT
#include "render/context/context.hpp"

#include "base/atomic_file.hpp"
#include "base/resources.hpp"
#include "render/context/gl.hpp"

#include <frostfill/error.hpp>

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdlib>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

namespace frostfill
{

namespace
{

/// What Mesa maps for a context with its threads [bytes]. When it gets less it may wait forever
/// for a thread that it could not start.
constexpr std::size_t kContextBytes = std::size_t{768} << 20;

/// A context takes a tenth of a second.
constexpr std::chrono::seconds kPatience{60};

/// Only before the first context: it loads the libraries, and those after it take far less.
void requireMemory()
{
    static std::atomic<bool> asked = false;
    if (!asked.exchange(true) && !mayMap(kContextBytes))
    {
        asked = false;
        throw Error(
            ErrorCode::outOfMemory,
            fmt::format("OpenGL takes some {} MiB, and the limit on the memory of this "
                        "process leaves less; raise it (ulimit -v), or omit picture.backend",
                        kContextBytes >> 20));
    }
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

Watchdog::Watchdog(std::chrono::milliseconds patience, std::string message, int exitCode)
{
    auto watch = [over = over_.get_future(), patience, text = std::move(message) + "\n", exitCode]
    {
        if (over.wait_for(patience) == std::future_status::timeout)
        {
            std::ignore = writeAll(
                STDERR_FILENO, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
            std::_Exit(exitCode); // what hangs would also hang in destructors
        }
    };
    try
    {
        thread_ = std::thread(std::move(watch));
    }
    catch (const std::system_error&)
    {
        return;
    }
}

Watchdog::~Watchdog()
{
    if (thread_.joinable())
    {
        over_.set_value();
        thread_.join();
    }
}

const std::vector<BackendChoice>& backendChoices()
{
    static const std::vector<BackendChoice> choices = {
        {Backend::osmesa, "osmesa", &openOsmesa, "apt install libosmesa6"},
        {Backend::egl, "egl", &openEgl, "apt install libegl1 libegl-mesa0 libgl1-mesa-dri"},
    };
    return choices;
}

std::unique_ptr<Context> openContext(Backend backend)
{
    requireMemory();
    const Watchdog watchdog(kPatience,
                            "frostfill: OpenGL has not answered for a minute, perhaps because "
                            "memory is short; omit picture.backend",
                            static_cast<int>(ErrorCode::noOpenGl));
    const std::vector<BackendChoice>& choices = backendChoices();
    const auto choice =
        std::find_if(choices.begin(), choices.end(),
                     [&](const BackendChoice& each) { return each.backend == backend; });
    try
    {
        return choice->open();
    }
    catch (const Error& error)
    {
        throw Error(ErrorCode::noOpenGl,
                    fmt::format("no OpenGL context is available: {} (to install it: {})",
                                error.what(), choice->remedy));
    }
}

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
    gl.member = reinterpret_cast<decltype(gl.member)>(load(#member));
    FROSTFILL_GL_FUNCTIONS(FROSTFILL_GL_LOAD)
#undef FROSTFILL_GL_LOAD
    return gl;
}

} // namespace frostfill
