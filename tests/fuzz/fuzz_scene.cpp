// SPDX-License-Identifier: MIT
// Any text as a scene file. A scene that is read is written, and read again as the same.
#include <frostfill/error.hpp>
#include <frostfill/scene.hpp>

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::string written;
    try
    {
        written = sceneToToml(
            frostfill::parseScene({reinterpret_cast<const char*>(data), size}, "fuzzed"));
    }
    catch (const frostfill::Error&)
    {
        return 0;
    }
    // An error here is a fault: what the program writes, it reads.
    if (sceneToToml(frostfill::parseScene(written, "written")) != written)
    {
        std::abort();
    }
    return 0;
}
