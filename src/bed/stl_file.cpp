// SPDX-License-Identifier: MIT
#include "bed/stl_file.hpp"

#include "bed/bed_files.hpp"
#include "bed/bed_summary.hpp"
#include "output/atomic_file.hpp"
#include "run_file/bytes.hpp"

#include <frostfill/error.hpp>

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>

namespace frostfill
{
namespace
{

Eigen::Vector3f normalOf(const StlTriangle& triangle)
{
    const Eigen::Vector3d a = triangle[0].cast<double>();
    const Eigen::Vector3d normal =
        (triangle[1].cast<double>() - a).cross(triangle[2].cast<double>() - a);
    return normal.normalized().cast<float>();
}

void putBinary(AtomicFile& file, const BedSurface& surface, BedPatch patch)
{
    surface.forEachPart(patch,
                        [&](std::span<const StlTriangle> triangles)
                        {
                            ByteWriter bytes;
                            bytes.bytes().reserve(50 * triangles.size());
                            for (const StlTriangle& triangle : triangles)
                            {
                                bytes.raw(normalOf(triangle));
                                bytes.raw(triangle);
                                bytes.raw(static_cast<std::uint16_t>(patch));
                            }
                            file.write(bytes.bytes());
                        });
}

void putText(AtomicFile& file, const BedSurface& surface, BedPatch patch)
{
    const char* name = kBedPatches[static_cast<std::size_t>(patch)];
    file.write(fmt::format("solid {}\n", name));
    const auto put = [](fmt::memory_buffer& text, const char* what, const Eigen::Vector3f& p)
    {
        fmt::format_to(std::back_inserter(text), FMT_COMPILE("{} {} {} {}\n"), what, p.x(), p.y(),
                       p.z());
    };
    surface.forEachPart(patch,
                        [&](std::span<const StlTriangle> triangles)
                        {
                            fmt::memory_buffer text;
                            for (const StlTriangle& triangle : triangles)
                            {
                                put(text, "facet normal", normalOf(triangle));
                                text.append(std::string_view("outer loop\n"));
                                for (const Eigen::Vector3f& corner : triangle)
                                {
                                    put(text, "vertex", corner);
                                }
                                text.append(std::string_view("endloop\nendfacet\n"));
                            }
                            file.write({text.data(), text.size()});
                        });
    file.write(fmt::format("endsolid {}\n", name));
}

} // namespace

void writeStl(const BedSurface& surface, std::span<const BedPatch> patches, bool ascii,
              const std::filesystem::path& name)
{
    AtomicFile file(name);
    if (!ascii)
    {
        std::size_t count = 0;
        for (const BedPatch patch : patches)
        {
            count += surface.triangles(patch);
        }
        if (count > 0xFFFFFFFF)
        {
            throw Error(ErrorCode::badData, "an STL file holds at most 4294967295 triangles; give "
                                            "a lower --resolution");
        }
        std::string head = "binary STL by Frostfill; patches: 0 inlet, 1 outlet, 2 wall, 3 spheres";
        head.resize(80, ' ');
        ByteWriter bytes;
        bytes.bytes() = head;
        bytes.raw(static_cast<std::uint32_t>(count));
        file.write(bytes.bytes());
    }
    for (const BedPatch patch : patches)
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
    constexpr std::array<BedPatch, 4> kAll = {BedPatch::inlet, BedPatch::outlet, BedPatch::wall,
                                              BedPatch::spheres};
    const BedSurface surface(bed);
    files.push_back(folder / "bed.stl");
    writeStl(surface, kAll, bed.settings().ascii, files.back());
    files.push_back(folder / "bed.stl.json");
    writeSummary(surfaceSummary(surface), files.back());
}

} // namespace frostfill
