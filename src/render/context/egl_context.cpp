// SPDX-License-Identifier: MIT
// EGL: where Mesa comes without OSMesa (from 25.1 on), and the way to a graphics card.
#include "render/context/context.hpp"

#include <frostfill/error.hpp>

#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{
namespace
{

// What we use of EGL 1.5, so that no headers of it are needed to build. Values are the registry's.
using Display = void*;
using Device = void*;
using Handle = void*; // of a configuration, surface or context
using Int = std::int32_t;
constexpr Int kNone = 0x3038;
constexpr Int kSurfaceType = 0x3033;
constexpr Int kPbufferBit = 0x0001;
constexpr Int kRenderableType = 0x3040;
constexpr Int kOpenGlBit = 0x0008;
constexpr unsigned kOpenGlApi = 0x30A2;
constexpr Int kExtensions = 0x3055;
constexpr Int kMajorVersion = 0x3098;
constexpr Int kMinorVersion = 0x30FB;
constexpr Int kProfileMask = 0x30FD;
constexpr Int kCoreProfileBit = 0x0001;
constexpr unsigned kPlatformDevice = 0x313F;
constexpr unsigned kPlatformSurfaceless = 0x31DD;

/// More devices than any machine has.
constexpr Int kMaxDevices = 64;

/// Opened when it is first asked for and kept until the process ends, as are its displays: closing
/// one would take the contexts of other renderers with it.
struct EglLibrary
{
    GlProcedure (*procedure)(const char*) = nullptr;
    unsigned (*bindApi)(unsigned) = nullptr;
    unsigned (*initialize)(Display, Int*, Int*) = nullptr;
    unsigned (*chooseConfig)(Display, const Int*, Handle*, Int, Int*) = nullptr;
    Handle (*createContext)(Display, Handle, Handle, const Int*) = nullptr;
    unsigned (*destroyContext)(Display, Handle) = nullptr;
    unsigned (*makeCurrent)(Display, Handle, Handle, Handle) = nullptr;
    Int (*error)() = nullptr;
    // Extensions; null where there are none.
    Display (*platformDisplay)(unsigned, void*, const Int*) = nullptr;
    unsigned (*queryDevices)(Int, Device*, Int*) = nullptr;
    const char* (*queryDeviceString)(Device, Int) = nullptr;
    std::string failure; ///< empty when the library is usable
};

EglLibrary openEglLibrary()
{
    makeShaderCache();
    EglLibrary egl;
    void* library = ::dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
    {
        const char* reason = ::dlerror();
        egl.failure = reason != nullptr ? reason : "libEGL.so.1";
        return egl;
    }
    const auto resolve = [&](const char* name, auto& function)
    {
        function = reinterpret_cast<std::decay_t<decltype(function)>>(::dlsym(library, name));
        if (function == nullptr)
        {
            egl.failure = fmt::format("the library has no {}", name);
        }
    };
    resolve("eglGetProcAddress", egl.procedure);
    resolve("eglBindAPI", egl.bindApi);
    resolve("eglInitialize", egl.initialize);
    resolve("eglChooseConfig", egl.chooseConfig);
    resolve("eglCreateContext", egl.createContext);
    resolve("eglDestroyContext", egl.destroyContext);
    resolve("eglMakeCurrent", egl.makeCurrent);
    resolve("eglGetError", egl.error);
    if (!egl.failure.empty())
    {
        return egl;
    }
    const auto extension = [&](const char* name, auto& function)
    { function = reinterpret_cast<std::decay_t<decltype(function)>>(egl.procedure(name)); };
    extension("eglGetPlatformDisplayEXT", egl.platformDisplay);
    extension("eglQueryDevicesEXT", egl.queryDevices);
    extension("eglQueryDeviceStringEXT", egl.queryDeviceString);
    if (egl.platformDisplay == nullptr)
    {
        egl.failure = "the library needs a screen (no eglGetPlatformDisplayEXT)";
    }
    return egl;
}

const EglLibrary& eglLibrary()
{
    static const EglLibrary library = openEglLibrary();
    return library;
}

class EglContext final : public Context
{
public:
    EglContext() : egl_(eglLibrary())
    {
        if (!egl_.failure.empty())
        {
            throw failure(egl_.failure);
        }
        std::string failures;
        for (Display display : displays())
        {
            try
            {
                create(display);
                makeCurrent();
                return;
            }
            catch (const Error& error)
            {
                failures += fmt::format("{}{}", failures.empty() ? "" : "; ", error.what());
            }
        }
        throw failure(failures);
    }

    ~EglContext() override
    {
        wake();
        egl_.destroyContext(display_, context_);
    }

    [[nodiscard]] const char* name() const override { return "egl"; }

    [[nodiscard]] GlProcedure procedure(const char* name) const override
    {
        return egl_.procedure(name);
    }

private:
    [[nodiscard]] static Error failure(const std::string& what)
    {
        return {ErrorCode::noOpenGl, "egl: " + what};
    }

    [[nodiscard]] bool isSoftware(Device device) const
    {
        const char* extensions = egl_.queryDeviceString(device, kExtensions);
        return extensions != nullptr &&
               std::string_view(extensions).find("EGL_MESA_device_software") != std::string::npos;
    }

    /// Returns graphics cards first, then Mesa's software device, then Mesa without a device.
    [[nodiscard]] std::vector<Display> displays() const
    {
        std::vector<Device> devices(kMaxDevices);
        Int count = 0;
        if (egl_.queryDevices != nullptr && egl_.queryDeviceString != nullptr)
        {
            egl_.queryDevices(kMaxDevices, devices.data(), &count);
        }
        devices.resize(static_cast<std::size_t>(count));
        std::stable_partition(devices.begin(), devices.end(),
                              [&](Device device) { return !isSoftware(device); });
        std::vector<Display> displays;
        for (Device device : devices)
        {
            displays.push_back(egl_.platformDisplay(kPlatformDevice, device, nullptr));
        }
        displays.push_back(egl_.platformDisplay(kPlatformSurfaceless, nullptr, nullptr));
        return displays;
    }

    void create(Display display)
    {
        if (display == nullptr || egl_.initialize(display, nullptr, nullptr) == 0)
        {
            throw failure(fmt::format("no display (EGL error {:#x})", egl_.error()));
        }
        egl_.bindApi(kOpenGlApi);
        constexpr std::array kConfig = {kSurfaceType, kPbufferBit, kRenderableType, kOpenGlBit,
                                        kNone};
        Handle config = nullptr;
        Int configs = 0;
        egl_.chooseConfig(display, kConfig.data(), &config, 1, &configs);
        // Without a configuration we try all the same: we draw to framebuffer objects only.
        constexpr std::array kContext = {kMajorVersion,   3,    kMinorVersion, 3, kProfileMask,
                                         kCoreProfileBit, kNone};
        Handle context =
            egl_.createContext(display, configs > 0 ? config : nullptr, nullptr, kContext.data());
        if (context == nullptr)
        {
            throw failure(
                fmt::format("no OpenGL 3.3 core context (EGL error {:#x})", egl_.error()));
        }
        display_ = display;
        context_ = context;
    }

    void bind() override
    {
        egl_.bindApi(kOpenGlApi);
        if (egl_.makeCurrent(display_, nullptr, nullptr, context_) == 0)
        {
            throw failure(
                fmt::format("the context cannot be made current (EGL error {:#x})", egl_.error()));
        }
    }

    void unbind() override { egl_.makeCurrent(display_, nullptr, nullptr, nullptr); }

    const EglLibrary& egl_;
    Display display_ = nullptr;
    Handle context_ = nullptr;
};

} // namespace

std::unique_ptr<Context> openEgl()
{
    return std::make_unique<EglContext>();
}

} // namespace frostfill
