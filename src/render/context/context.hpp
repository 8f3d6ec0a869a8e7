// SPDX-License-Identifier: MIT
// Room: OpenGL without a screen: contexts, functions, framebuffers, shaders. It knows nothing of
// spheres.
#pragma once

#include <frostfill/renderer.hpp>

#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>

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
    /// Null when there is no such function.
    [[nodiscard]] virtual GlProcedure procedure(const char* name) const = 0;
    /// Directs the calls of this thread to this context. Throws Error noOpenGl.
    void makeCurrent();

protected:
    /// To be called first by the destructor of a context: it must not be current while it goes.
    void wake();

private:
    /// Tells the library. Throws Error noOpenGl.
    virtual void bind() = 0;
    virtual void unbind() = 0;

    /// Of this thread, across all libraries: those of Mesa share one table of functions, so a
    /// context has to be unbound in its own library before one of another is bound.
    static thread_local Context* current;
};

/// Opens the library and creates a context, current to this thread. Throws Error noOpenGl.
[[nodiscard]] std::unique_ptr<Context> openOsmesa();
/// The same through EGL: on a graphics card, on Mesa's software device, or on no device at all,
/// whichever works first.
[[nodiscard]] std::unique_ptr<Context> openEgl();

/// Ends the process, with a message on standard error, when this lives for too long: for calls of
/// other libraries that can wait forever and cannot be interrupted.
class Watchdog
{
public:
    /// Where no thread can be started nothing is watched.
    Watchdog(std::chrono::milliseconds patience, std::string message, int exitCode);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

private:
    std::promise<void> over_;
    std::thread thread_;
};

/// A backend that can be asked for.
struct BackendChoice
{
    Backend backend;
    const char* name;
    std::unique_ptr<Context> (*open)();
    const char* remedy; ///< the command that installs it
};
[[nodiscard]] const std::vector<BackendChoice>& backendChoices();

/// Opens a backend of backendChoices(). Throws Error noOpenGl, which has the remedy, and
/// outOfMemory when the process has too little. A library that hangs for a minute ends the process
/// with the code of noOpenGl: nothing else gets out of it.
[[nodiscard]] std::unique_ptr<Context> openContext(Backend backend);

} // namespace frostfill
