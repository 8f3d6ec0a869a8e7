// SPDX-License-Identifier: MIT
#include "analysis/analysis_input.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

/// More of what multiplies the work than any packing needs.
constexpr std::size_t kMostBins = 100'000;
constexpr std::size_t kFewestSamples = 16;
constexpr std::size_t kMostSamples = 10'000'000'000;
constexpr double kLongestRange = 50;

void require(bool holds, const char* what)
{
    if (!holds)
    {
        throw Error(ErrorCode::usage, what);
    }
}

bool needsWalls(AnalysisKind kind)
{
    return kind == AnalysisKind::porosity || kind == AnalysisKind::cells;
}

bool isAsked(const AnalysisSettings& settings, AnalysisKind kind)
{
    if (settings.only.empty())
    {
        return !needsWalls(kind) || (settings.bounds == AnalysisBounds::walls &&
                                     (kind != AnalysisKind::cells || hasVoronoiCells()));
    }
    return std::find(settings.only.begin(), settings.only.end(), kind) != settings.only.end();
}

void checkSpheres(const Packing& packing)
{
    if (packing.centres.size() != packing.radii.size())
    {
        throw Error(ErrorCode::badData, fmt::format("{} centres and {} radii do not go together",
                                                    packing.centres.size(), packing.radii.size()));
    }
    for (std::size_t k = 0; k < packing.radii.size(); ++k)
    {
        if (!std::isfinite(packing.radii[k]) || packing.radii[k] <= 0)
        {
            throw Error(ErrorCode::badData, fmt::format("sphere {} has the radius {:g}, which must "
                                                        "be a number above 0",
                                                        k, packing.radii[k]));
        }
    }
}

/// The image of a place in a box that repeats.
Eigen::Vector3d wrapped(const Eigen::Vector3d& p, const Eigen::AlignedBox3d& box)
{
    const Eigen::Array3d share = (p - box.min()).array() / box.sizes().array();
    return box.min() + ((share - share.floor()) * box.sizes().array()).matrix();
}

/// Keeps the spheres that are inside, and counts the others.
void takeSpheres(const Packing& packing, const Container& container, Threads& threads,
                 PackingAnalysis& analysis)
{
    const std::size_t count = packing.radii.size();
    const bool repeats = analysis.settings.bounds == AnalysisBounds::periodic;
    std::vector<std::uint8_t> inside(count, 0);
    forEachPart(threads, count, AnalysisInput::kInPart,
                [&](std::size_t first, std::size_t end, std::size_t)
                {
                    for (std::size_t k = first; k < end; ++k)
                    {
                        const Eigen::Vector3d& centre = packing.centres[k];
                        inside[k] =
                            centre.allFinite() && (repeats || container.contains(centre)) ? 1 : 0;
                    }
                });
    for (std::size_t k = 0; k < count; ++k)
    {
        if (inside[k] != 0)
        {
            analysis.ids.push_back(static_cast<std::uint32_t>(k));
            analysis.centres.push_back(repeats ? wrapped(packing.centres[k], container.box())
                                               : packing.centres[k]);
            analysis.radii.push_back(packing.radii[k]);
            analysis.sphereVolume += ballVolume(packing.radii[k]);
        }
        else
        {
            ++(packing.centres[k].allFinite() ? analysis.outside : analysis.notFinite);
        }
    }
    analysis.wallDistances.resize(analysis.ids.size());
    forEachPart(threads, analysis.ids.size(), AnalysisInput::kInPart,
                [&](std::size_t first, std::size_t end, std::size_t)
                {
                    for (std::size_t k = first; k < end; ++k)
                    {
                        analysis.wallDistances[k] =
                            repeats ? std::numeric_limits<double>::infinity()
                                    : container.distanceToWall(analysis.centres[k]);
                    }
                });
}

} // namespace

bool PackingAnalysis::isInBulk(std::size_t k) const
{
    return frostfill::isInBulk(wallDistances[k], depths[k], largestRadius);
}

const char* bulkInWords()
{
    return kBulkInWords;
}

void checkSettings(const AnalysisSettings& settings)
{
    require(settings.bins > 0 && settings.bins <= kMostBins,
            "the number of bins must be from 1 to 100000");
    require(settings.range > 0 && settings.range <= kLongestRange,
            "the range must be above 0 and at most 50 mean diameters");
    require(settings.contactGap >= 0 && settings.contactGap <= 1,
            "the gap of a contact must be from 0 to 1 of the smaller radius");
    require(settings.bondLength >= 1 && settings.bondLength <= 3,
            "the length of a bond must be from 1 to 3 sums of both radii");
    require(settings.samples >= kFewestSamples && settings.samples <= kMostSamples,
            "the number of samples must be from 16 to 1e10");
    require(!settings.centre || settings.centre->allFinite(), "the centre must be three numbers");
    require(!settings.below || *settings.below > 0,
            "the height below which the bed is must be above 0");
    require(!settings.forces ||
                (*settings.forces >= 0 && *settings.forces <= JudgeSettings::kMostFriction),
            "the friction of forces must be from 0 to 8");
    require(settings.bounds == AnalysisBounds::walls ||
                (!settings.forces &&
                 std::none_of(settings.only.begin(), settings.only.end(), needsWalls)),
            "porosity, cells and forces need walls: a mesh, or a box that does not repeat");
    require(settings.threads >= 0, "the number of threads must not be negative");
    if (!hasVoronoiCells() && std::find(settings.only.begin(), settings.only.end(),
                                        AnalysisKind::cells) != settings.only.end())
    {
        throw Error(ErrorCode::missingProgram, missingVoronoiCells());
    }
}

double meanDiameterOf(const std::vector<double>& radii)
{
    double sum = 0;
    for (const double radius : radii)
    {
        sum += radius;
    }
    return radii.empty() ? 1 : 2 * sum / static_cast<double>(radii.size());
}

const std::vector<std::string>& analysisNames()
{
    static const std::vector<std::string> names = {"porosity", "pairs", "contacts",
                                                   "cells",    "order", "sizes"};
    return names;
}

AnalysisKind analysisKind(const std::string& name)
{
    const std::vector<std::string>& names = analysisNames();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
    {
        throw Error(ErrorCode::usage, fmt::format("there is no analysis '{}'; there are {}", name,
                                                  fmt::join(names, ", ")));
    }
    return static_cast<AnalysisKind>(found - names.begin());
}

const char* missingVoronoiCells()
{
    return "Voronoi cells need voro++, which was not there when this program was built: apt-get "
           "install voro++-dev, then configure and build again";
}

ProfileFrame::ProfileFrame(const AnalysisInput& input)
    : up_(static_cast<Eigen::Index>(input.settings.up))
{
    const double end = std::min(input.container.box().max()[up_], input.top.highest());
    std::vector<Eigen::Vector3d> corners; // of the object, as if it were cut there
    const TriangleMesh& mesh = input.container.mesh();
    for (const auto& triangle : mesh.triangles)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Eigen::Vector3d& here = mesh.vertices[triangle[k]];
            const Eigen::Vector3d& next = mesh.vertices[triangle[(k + 1) % 3]];
            if (here[up_] <= end)
            {
                corners.push_back(here);
            }
            if ((here[up_] <= end) != (next[up_] <= end))
            {
                const double share = (end - here[up_]) / (next[up_] - here[up_]);
                corners.emplace_back(here + share * (next - here));
                corners.back()[up_] = end;
            }
        }
    }
    for (const Eigen::Vector3d& corner : corners)
    {
        box_.extend(corner);
    }
    centre_ = input.settings.centre.value_or(box_.center());
    for (const Eigen::Vector3d& corner : corners)
    {
        widest_ = std::max(widest_, radius(corner));
    }
}

PackingAnalysis analyseIn(const Container& container, const Packing& packing,
                          const AnalysisSettings& settings)
{
    PackingAnalysis analysis;
    analysis.settings = settings;
    analysis.meshVolume = container.report().volume;
    Threads threads(settings.threads);
    takeSpheres(packing, container, threads, analysis);
    if (analysis.ids.empty())
    {
        return analysis;
    }
    const auto up = static_cast<Eigen::Index>(settings.up);
    const BedTop top = settings.bounds == AnalysisBounds::periodic
                           ? BedTop(up, std::numeric_limits<double>::infinity())
                       : settings.below ? BedTop(up, container.box().min()[up] + *settings.below)
                                        : BedTop(up, analysis.centres, analysis.radii);
    for (const Eigen::Vector3d& centre : analysis.centres)
    {
        analysis.depths.push_back(top.depth(centre));
    }
    analysis.largestRadius = *std::max_element(analysis.radii.begin(), analysis.radii.end());
    const SphereLevels levels(analysis.centres, analysis.radii);
    const AnalysisInput input{settings,
                              container,
                              levels,
                              analysis.centres,
                              analysis.radii,
                              analysis.wallDistances,
                              top,
                              analysis.depths,
                              packing.rollingFriction,
                              analysis.largestRadius,
                              meanDiameterOf(analysis.radii),
                              threads};
    const auto find = [&](AnalysisKind kind, auto& result, auto function)
    {
        if (isAsked(settings, kind))
        {
            result = function(input);
        }
    };
    find(AnalysisKind::porosity, analysis.porosity, findPorosity);
    find(AnalysisKind::pairs, analysis.pairs, findPairs);
    find(AnalysisKind::contacts, analysis.contacts, findContacts);
    find(AnalysisKind::cells, analysis.cells, findCells);
    find(AnalysisKind::order, analysis.order, findOrder);
    find(AnalysisKind::sizes, analysis.sizes, findSizes);
    return analysis;
}

PackingAnalysis analysePacking(const TriangleMesh& mesh, const Packing& packing,
                               const AnalysisSettings& settings)
{
    checkSettings(settings);
    checkSpheres(packing);
    PackingAnalysis analysis =
        analyseIn(Container(mesh, meanDiameterOf(packing.radii)), packing, settings);
    if (analysis.ids.empty())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("none of {} centres is inside the mesh: are both in the same unit "
                                "and place?",
                                packing.radii.size()));
    }
    return analysis;
}

} // namespace frostfill
