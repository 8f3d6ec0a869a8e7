// SPDX-License-Identifier: MIT
// The libraries that give contexts without a screen: OSMesa, which is Mesa's software renderer
// drawing to memory, and EGL, where Mesa comes without OSMesa (from 25.1 on), and the way to a
// graphics card.
#include "render/context/context.hpp"
#include "render/context/gl.hpp"

#include <frostfill/error.hpp>

#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{
namespace
{

/// Opens the first of these libraries, or says why there is none.
void* openFirst(std::initializer_list<const char*> names, std::string& failure)
{
    std::error_code none;
    if (const char* folder = std::getenv("MESA_SHADER_CACHE_DIR"))
    {
        std::filesystem::create_directories(folder, none); // Mesa does not
    }
    for (const char* name : names)
    {
        if (void* library = ::dlopen(name, RTLD_NOW | RTLD_LOCAL))
        {
            failure.clear();
            return library;
        }
        const char* reason = ::dlerror();
        failure += failure.empty() ? "" : "; ";
        failure += reason != nullptr ? reason : name;
    }
    return nullptr;
}

template <class Function>
void resolve(void* library, const char* name, Function& function, std::string& failure)
{
    function = reinterpret_cast<Function>(::dlsym(library, name));
    if (function == nullptr)
    {
        failure = fmt::format("the library has no {}", name);
    }
}

// What we use of OSMesa, so that no headers of it are needed to build. Values are GL/osmesa.h's.
struct OsmesaHandle; // of a context
constexpr int kFormat = 0x22;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kContextMajorVersion = 0x36;
constexpr int kContextMinorVersion = 0x37;

/// OSMesa insists on a buffer of its own. We draw to framebuffer objects, so the smallest will do.
constexpr int kOwnBufferSize = 4;

/// The library, opened when it is first asked for and kept until the process ends: Mesa leaves
/// threads and thread-local data behind that do not survive its unloading. Linking it instead would
/// give null functions, without any error, wherever libGL came before it.
struct OsmesaLibrary
{
    OsmesaHandle* (*create)(const int*, OsmesaHandle*) = nullptr;
    void (*destroy)(OsmesaHandle*) = nullptr;
    GLboolean (*makeCurrent)(OsmesaHandle*, void*, GLenum, GLsizei, GLsizei) = nullptr;
    GlProcedure (*procedure)(const char*) = nullptr;
    std::string failure; ///< empty when the library is usable
};

OsmesaLibrary openOsmesaLibrary()
{
    OsmesaLibrary result;
    if (void* library =
            openFirst({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}, result.failure))
    {
        resolve(library, "OSMesaCreateContextAttribs", result.create, result.failure);
        resolve(library, "OSMesaDestroyContext", result.destroy, result.failure);
        resolve(library, "OSMesaMakeCurrent", result.makeCurrent, result.failure);
        resolve(library, "OSMesaGetProcAddress", result.procedure, result.failure);
    }
    return result;
}

const OsmesaLibrary& osmesaLibrary()
{
    static const OsmesaLibrary library = openOsmesaLibrary();
    return library;
}

class OsmesaContext final : public Context
{
public:
    OsmesaContext() : library_(osmesaLibrary())
    {
        if (!library_.failure.empty())
        {
            throw Error(ErrorCode::noOpenGl, "osmesa: " + library_.failure);
        }
        // Asked for 3.3 it gives the newest core context it has; asked for its newest, nothing.
        constexpr std::array kAttributes = {kFormat,
                                            static_cast<int>(GL_RGBA),
                                            kProfile,
                                            kCoreProfile,
                                            kContextMajorVersion,
                                            3,
                                            kContextMinorVersion,
                                            3,
                                            0};
        context_ = library_.create(kAttributes.data(), nullptr);
        if (context_ == nullptr)
        {
            throw Error(ErrorCode::noOpenGl, "osmesa: no OpenGL 3.3 core context can be created");
        }
        makeCurrent();
    }

    ~OsmesaContext() override
    {
        wake();
        if (context_ != nullptr)
        {
            library_.destroy(context_);
        }
    }

    [[nodiscard]] const char* name() const override { return "osmesa"; }

    [[nodiscard]] GlProcedure procedure(const char* name) const override
    {
        return library_.procedure(name);
    }

private:
    void bind() override
    {
        if (library_.makeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kOwnBufferSize,
                                 kOwnBufferSize) == GL_FALSE)
        {
            throw Error(ErrorCode::noOpenGl, "osmesa: the context cannot be made current");
        }
    }

    void unbind() override { library_.makeCurrent(nullptr, nullptr, 0, 0, 0); }

    const OsmesaLibrary& library_;
    OsmesaHandle* context_ = nullptr;
    std::array<unsigned char, std::size_t{kOwnBufferSize} * kOwnBufferSize * 4> buffer_{};
};

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
    EglLibrary egl;
    if (void* library = openFirst({"libEGL.so.1"}, egl.failure))
    {
        resolve(library, "eglGetProcAddress", egl.procedure, egl.failure);
        resolve(library, "eglBindAPI", egl.bindApi, egl.failure);
        resolve(library, "eglInitialize", egl.initialize, egl.failure);
        resolve(library, "eglChooseConfig", egl.chooseConfig, egl.failure);
        resolve(library, "eglCreateContext", egl.createContext, egl.failure);
        resolve(library, "eglDestroyContext", egl.destroyContext, egl.failure);
        resolve(library, "eglMakeCurrent", egl.makeCurrent, egl.failure);
        resolve(library, "eglGetError", egl.error, egl.failure);
    }
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
        displays.reserve(devices.size() + 1);
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

std::unique_ptr<Context> openOsmesa()
{
    return std::make_unique<OsmesaContext>();
}

std::unique_ptr<Context> openEgl()
{
    return std::make_unique<EglContext>();
}

} // namespace frostfill
