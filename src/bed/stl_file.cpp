// SPDX-License-Identifier: MIT
#include "bed/stl_file.hpp"

#include "base/atomic_file.hpp"
#include "bed/bed_files.hpp"
#include "bed/bed_summary.hpp"
#include "output/stl_text.hpp"
#include "run_file/bytes.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <numeric>

namespace frostfill
{
namespace
{

void putBinary(AtomicFile& file, const BedSurface& surface, std::size_t patch)
{
    surface.forEachPart(patch,
                        [&](std::span<const StlTriangle> triangles)
                        {
                            ByteWriter bytes;
                            bytes.bytes().reserve(50 * triangles.size());
                            for (const StlTriangle& triangle : triangles)
                            {
                                bytes.raw(Eigen::Vector3f(facetNormal(triangle).cast<float>()));
                                bytes.raw(triangle);
                                bytes.raw(static_cast<std::uint16_t>(patch));
                            }
                            file.write(bytes.bytes());
                        });
}

void putText(AtomicFile& file, const BedSurface& surface, std::size_t patch)
{
    const std::string& name = surface.bed().patches()[patch].name;
    file.write(fmt::format("solid {}\n", name));
    surface.forEachPart(patch,
                        [&](std::span<const StlTriangle> triangles)
                        {
                            fmt::memory_buffer text;
                            for (const StlTriangle& triangle : triangles)
                            {
                                putFacet(text, triangle);
                            }
                            file.write({text.data(), text.size()});
                        });
    file.write(fmt::format("endsolid {}\n", name));
}

} // namespace

void writeStl(const BedSurface& surface, std::span<const std::size_t> patches, bool ascii,
              const std::filesystem::path& name)
{
    AtomicFile file(name);
    if (!ascii)
    {
        std::size_t count = 0;
        for (const std::size_t patch : patches)
        {
            count += surface.triangles(patch);
        }
        if (count > 0xFFFFFFFF)
        {
            throw Error(ErrorCode::badData, "an STL file holds at most 4294967295 triangles; give "
                                            "a lower --resolution");
        }
        std::string head = "binary STL by Frostfill; patches:";
        for (const std::size_t patch : patches)
        {
            head += fmt::format("{} {} {}", patch > 0 ? "," : "", patch,
                                surface.bed().patches()[patch].name);
        }
        head.resize(80, ' ');
        ByteWriter bytes;
        bytes.bytes() = head;
        bytes.raw(static_cast<std::uint32_t>(count));
        file.write(bytes.bytes());
    }
    for (const std::size_t patch : patches)
    {
        if (surface.triangles(patch) > 0)
        {
            ascii ? putText(file, surface, patch) : putBinary(file, surface, patch);
        }
    }
    file.commit();
}

void writeStlBed(const Bed& bed, const std::filesystem::path& folder, Files& files)
{
    std::vector<std::size_t> all(bed.patches().size());
    std::iota(all.begin(), all.end(), 0);
    const BedSurface surface(bed);
    files.push_back(folder / "bed.stl");
    writeStl(surface, all, bed.settings().ascii, files.back());
    files.push_back(folder / "bed.stl.json");
    writeSummary(surfaceSummary(surface), files.back());
}

} // namespace frostfill
