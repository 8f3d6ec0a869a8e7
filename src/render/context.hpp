// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/renderer.hpp>

#include <memory>
#include <string>

namespace frostfill
{

using GlProcedure = void (*)();

/// An OpenGL 3.3 core context that needs no screen. It is used by one thread at a time.
class Context
{
public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    /// The backend, as a user names it.
    [[nodiscard]] virtual const char* name() const = 0;
    /// Directs the calls of this thread to this context. Throws Error noOpenGl.
    virtual void makeCurrent() = 0;
    /// Null when there is no such function.
    [[nodiscard]] virtual GlProcedure procedure(const char* name) const = 0;
};

/// Opens the library and creates a context, current to this thread. Throws Error noOpenGl.
[[nodiscard]] std::unique_ptr<Context> openOsmesa();

/// A backend that can be asked for.
struct BackendChoice
{
    Backend backend;
    const char* name;
    std::unique_ptr<Context> (*open)();
    const char* remedy; ///< the command that installs it
};
/// In the order in which `automatic` tries them.
[[nodiscard]] const std::vector<BackendChoice>& backendChoices();

/// Throws Error noOpenGl, which lists every attempt and its remedy.
[[nodiscard]] std::unique_ptr<Context> openContext(Backend backend);

} // namespace frostfill
