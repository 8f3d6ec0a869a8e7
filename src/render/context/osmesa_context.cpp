// SPDX-License-Identifier: MIT
// OSMesa: Mesa's software renderer, drawing to memory.
#include "render/context/context.hpp"
#include "render/context/gl.hpp"

#include <frostfill/error.hpp>

#include <dlfcn.h>
#include <fmt/core.h>

#include <array>
#include <cstdlib>
#include <string>

namespace frostfill
{
namespace
{

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

template <class Function>
void resolve(void* library, const char* name, OsmesaLibrary& result, Function& function)
{
    function = reinterpret_cast<Function>(::dlsym(library, name));
    if (function == nullptr)
    {
        result.failure = fmt::format("the library has no {}", name);
    }
}

OsmesaLibrary openOsmesaLibrary()
{
    makeShaderCache();
    OsmesaLibrary result;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
    {
        void* library = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr)
        {
            const char* reason = ::dlerror();
            result.failure += result.failure.empty() ? "" : "; ";
            result.failure += reason != nullptr ? reason : name;
            continue;
        }
        result.failure.clear();
        resolve(library, "OSMesaCreateContextAttribs", result, result.create);
        resolve(library, "OSMesaDestroyContext", result, result.destroy);
        resolve(library, "OSMesaMakeCurrent", result, result.makeCurrent);
        resolve(library, "OSMesaGetProcAddress", result, result.procedure);
        return result;
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

} // namespace

std::unique_ptr<Context> openOsmesa()
{
    return std::make_unique<OsmesaContext>();
}

} // namespace frostfill
