// SPDX-License-Identifier: MIT
#include "bed/bed.hpp"

#include "base/read_number.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace frostfill
{
namespace
{

/// Cosine of the angle by which a flat end may be askew, and share of the height that it may be
/// away from the end. Larger: slopes count as ends. Smaller: rounding takes ends away.
constexpr double kEndNormal = 0.9999;
constexpr double kAtEnd = 1e-4;
/// Share of the largest coordinate below which one is 0.
constexpr double kDust = 1e-14;

[[noreturn]] void refuse(const std::string& what)
{
    throw Error(ErrorCode::usage, what);
}

/// Coordinates that only rounding keeps from being 0, such as those of a tube that was made with
/// sines: programs that test a surface for crossings trip over them.
TriangleMesh withoutDust(TriangleMesh mesh)
{
    double longest = 0;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        longest = std::max(longest, vertex.cwiseAbs().maxCoeff());
    }
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = (vertex.array().abs() < kDust * longest).select(0, vertex);
    }
    return mesh;
}

/// Returns the kind of each triangle: the flat ends of the mesh are inlet and outlet.
std::vector<PatchKind> kindsByEnds(const TriangleMesh& mesh, const Eigen::Vector3d& up)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        low = std::min(low, up.dot(vertex));
        high = std::max(high, up.dot(vertex));
    }
    const double margin = kAtEnd * (high - low);
    std::vector<PatchKind> kinds;
    for (const auto& triangle : mesh.triangles)
    {
        const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
        const Eigen::Vector3d& b = mesh.vertices[triangle[1]];
        const Eigen::Vector3d& c = mesh.vertices[triangle[2]];
        const double slope = (b - a).cross(c - a).normalized().dot(up);
        const double height = up.dot(a);
        kinds.push_back(slope < -kEndNormal && height < low + margin   ? PatchKind::inlet
                        : slope > kEndNormal && height > high - margin ? PatchKind::outlet
                                                                       : PatchKind::wall);
    }
    return kinds;
}

/// Returns the patch of each triangle. A part called inlet or outlet is that patch, wherever it is.
/// A part of one kind gives its name to the patch; the ends of a part with ends and walls keep
/// theirs.
std::vector<BedPatch> patchesOf(const BedContainer& container, const Eigen::Vector3d& up)
{
    std::vector<PatchKind> kinds = kindsByEnds(container.mesh, up);
    std::vector<std::string> names(kinds.size());
    for (std::size_t t = 0; t < container.partOf.size(); ++t)
    {
        const std::uint32_t part = container.partOf[t];
        names[t] = part == BedContainer::kNoPart ? "" : container.parts[part];
    }
    for (const PatchKind end : {PatchKind::inlet, PatchKind::outlet})
    {
        const std::string called = kPatchNames[static_cast<std::size_t>(end)];
        const bool isNamed = std::find(names.begin(), names.end(), called) != names.end();
        for (std::size_t t = 0; isNamed && t < kinds.size(); ++t)
        {
            kinds[t] = names[t] == called ? end : kinds[t] == end ? PatchKind::wall : kinds[t];
        }
    }
    std::map<std::string, PatchKind> kindOf = {{"wall", PatchKind::wall}};
    for (std::size_t t = 0; t < kinds.size(); ++t)
    {
        PatchKind& kind = kindOf.try_emplace(names[t], kinds[t]).first->second;
        kind = kind == kinds[t] ? kind : PatchKind::wall;
    }
    std::vector<BedPatch> patches;
    for (std::size_t t = 0; t < kinds.size(); ++t)
    {
        const bool hasName = !names[t].empty() && kindOf[names[t]] == kinds[t];
        patches.push_back(
            {kinds[t], hasName ? names[t] : kPatchNames[static_cast<std::size_t>(kinds[t])]});
    }
    return patches;
}

} // namespace

void parseContacts(const std::string& text, BedSettings& result)
{
    BedSettings settings = result; // which stays as it is if the text is refused
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string name = text.substr(0, colon);
    double* value = nullptr;
    if (name == "shrink")
    {
        settings.contacts = ContactTreatment::shrink;
        value = &settings.factor;
    }
    else if (name == "caps")
    {
        settings.contacts = ContactTreatment::caps;
        value = &settings.gap;
    }
    else if (name == "none")
    {
        settings.contacts = ContactTreatment::none;
    }
    else
    {
        refuse(fmt::format("there is no treatment of contacts '{}'; there are none, shrink, caps",
                           name));
    }
    if (colon < text.size())
    {
        const auto number = readNumber<double>(std::string_view(text).substr(colon + 1));
        if (!value || !number)
        {
            refuse(fmt::format("'{}' is no treatment of contacts; write none, shrink:FACTOR or "
                               "caps:GAP",
                               text));
        }
        *value = *number;
    }
    checkBedSettings(settings);
    result = settings;
}

void checkBedSettings(const BedSettings& settings)
{
    // Written so that what is no number is refused, too.
    if (!(settings.factor > 0 && settings.factor < 1))
    {
        refuse("shrink needs a factor above 0 and below 1, such as shrink:0.99");
    }
    if (!(settings.gap >= 1e-4 && settings.gap <= 0.2))
    {
        refuse("the gap of caps must be from 0.0001 to 0.2 radii");
    }
    if (settings.resolution < 1 || settings.resolution > 100)
    {
        refuse("the resolution of spheres must be from 1 to 100: they have 20 N^2 triangles");
    }
    if (settings.voxels < 2 || settings.voxels > 4096)
    {
        refuse("the number of voxels along the longest side must be from 2 to 4096");
    }
    if (!(settings.cell >= 0.01 && settings.cell <= 10))
    {
        refuse("the edge of a cell must be from 0.01 to 10 mean diameters");
    }
    if (settings.threads < 0)
    {
        refuse("the number of threads must not be negative");
    }
}

Bed::Bed(const BedContainer& container, std::vector<Eigen::Vector3d> centres,
         std::vector<double> radii, const Eigen::Vector3d& up, const BedSettings& settings,
         double unitsPerMetre)
    : settings_(settings), threads_(std::make_unique<Threads>(settings.threads)),
      centres_(std::move(centres)), radii_(std::move(radii)), up_(up),
      surface_(withoutDust(container.mesh)), levels_(centres_, radii_),
      unitsPerMetre_(unitsPerMetre), containerVolume_(inspectInterior(container.mesh).volume)
{
    for (const double radius : radii_)
    {
        meanDiameter_ += 2 * radius / static_cast<double>(radii_.size());
    }
    const std::vector<BedPatch> patches = patchesOf(container, up);
    std::set<BedPatch> all(patches.begin(), patches.end());
    all.insert({PatchKind::spheres, "spheres"});
    patches_.assign(all.begin(), all.end());
    for (const BedPatch& patch : patches)
    {
        patchOf_.push_back(static_cast<std::size_t>(
            std::lower_bound(patches_.begin(), patches_.end(), patch) - patches_.begin()));
    }
}

double Bed::porosity() const
{
    double volume = 0;
    for (const double radius : radii_)
    {
        volume += 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    }
    return 1 - volume / containerVolume_;
}

} // namespace frostfill
