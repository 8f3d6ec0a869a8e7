// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/renderer.hpp>
#include <frostfill/view.hpp>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace frostfill::test
{

inline bool hasBackend(const std::string& name)
{
    static const std::vector<BackendAttempt> attempts = probeBackends();
    return std::any_of(attempts.begin(), attempts.end(),
                       [&](const BackendAttempt& attempt)
                       { return attempt.name == name && attempt.works; });
}

/// What of OpenGL is there: OSMesa, or where that is missing EGL, which draws the same bytes with
/// the same Mesa. None: what a test asks of OpenGL cannot be asked here.
inline std::optional<Backend> openGl()
{
    for (const auto& [name, backend] :
         {std::pair{"osmesa", Backend::osmesa}, std::pair{"egl", Backend::egl}})
    {
        if (hasBackend(name))
        {
            return backend;
        }
    }
    return {};
}
inline const std::string kNoOpenGl = "there is neither OSMesa nor EGL";

/// That of the default, and OpenGL where it is there.
inline std::vector<Backend> backends()
{
    std::vector<Backend> all = {Backend::builtin};
    if (const std::optional<Backend> found = openGl())
    {
        all.push_back(*found);
    }
    return all;
}

/// The way in which a test draws: that of the default, which needs no OpenGL, or OpenGL where
/// FROSTFILL_TESTED_BACKEND says so and it is there. CTest runs each test of pictures in both ways.
inline Backend drawnWith()
{
    const char* name = std::getenv("FROSTFILL_TESTED_BACKEND");
    return name != nullptr && name == std::string("osmesa") ? openGl().value_or(Backend::automatic)
                                                            : Backend::automatic;
}

} // namespace frostfill::test
