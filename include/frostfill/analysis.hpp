// SPDX-License-Identifier: MIT
// Room: what a finished packing is like: porosity, neighbours, contacts, cells, order, sizes.
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/packing.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// What may be asked of a packing, in the order in which it is answered.
enum class AnalysisKind : std::uint8_t
{
    porosity,
    pairs,
    contacts,
    cells,
    order,
    sizes,
};

/// The words of --only, in the order of AnalysisKind.
[[nodiscard]] const std::vector<std::string>& analysisNames();
/// Throws Error usage, with all of them, for another word.
[[nodiscard]] AnalysisKind analysisKind(const std::string& name);

/// The role of the mesh around a packing.
enum class AnalysisBounds : std::uint8_t
{
    walls,
    none,     ///< a box around spheres of which no container is known: porosity and cells need one
    periodic, ///< a box along the axes that repeats in all directions: it has no walls, no cells
};

/// The container of a packing.
struct PackingWalls
{
    TriangleMesh mesh;
    AnalysisBounds bounds = AnalysisBounds::walls;
};
/// A box by its size, from 0 on, or by its lowest corner and its highest one: three numbers or six.
/// Throws Error usage.
[[nodiscard]] PackingWalls wallsOfBox(const std::vector<double>& numbers, bool periodic);
/// A box around all spheres, which is no wall. Throws Error badData if no centre is finite.
[[nodiscard]] PackingWalls wallsAround(const Packing& packing);
/// judgePacking; without walls only the overlaps of spheres, and of their images in a box that
/// repeats, mean something. Throws Error usage for a friction then.
[[nodiscard]] QualityReport judgePacking(const PackingWalls& walls, const Packing& packing, Axis up,
                                         const JudgeSettings& settings = {});

struct AnalysisSettings
{
    AnalysisBounds bounds = AnalysisBounds::walls;
    Axis up = Axis::y; ///< of the profiles
    /// A point of the axis of the radial profiles [mesh unit]; none: the middle of the mesh's box.
    std::optional<Eigen::Vector3d> centre = {};
    /// [mesh unit] Height above the foot of the mesh at which the bed ends; none: at its surface,
    /// which is over a place the highest top of the spheres within 1.5 of their radii.
    std::optional<double> below = {};
    std::size_t bins = 50;    ///< of each profile along and about the axis
    double range = 5;         ///< [mean diameter] of g(r) and of the distance from the wall
    double contactGap = 0.01; ///< [smaller radius] below which a gap is a contact
    double bondLength = 1.3;  ///< [sum of both radii] up to which two are bonded, for Q6
    /// Contacts, walls included, that a sphere needs to be held: three carry one under gravity.
    std::uint32_t rattlersBelow = 3;
    /// Friction under which contacts get forces: those that hold all spheres at once, as the judge
    /// finds them; none: no forces. One set of many that would do.
    std::optional<double> forces = {};
    std::size_t samples = std::size_t{1} << 20; ///< places at which porosity is sampled
    int threads = 0;                            ///< 0: one for each core; no bit depends on it
    /// Which analyses; none: all, without the cells where they are not built in.
    std::vector<AnalysisKind> only = {};
};

/// A row of a profile, of the part of the bed between two distances [mesh unit].
struct PorosityBin
{
    double from = 0;
    double to = 0;
    double porosity = 0;     ///< [1] share that no sphere covers
    double error = 0;        ///< [1] its standard error; 0 for a closed form
    double objectVolume = 0; ///< [unit^3] of the part; parts without volume have no row
};

/// A row of g(r). Bin k is centred at k times the width, so that spheres that touch are within one.
struct PairBin
{
    double from = 0;
    double to = 0;
    double g = 0;          ///< [1] density of neighbours over their mean density within the range
    double neighbours = 0; ///< of a sphere, on average, up to `to`
};

struct PairCorrelation
{
    double range = 0;         ///< [mesh unit] what was asked, or what the object has room for
    std::size_t centres = 0;  ///< spheres whose ball of that radius lies within the bed
    double numberDensity = 0; ///< [1/unit^3] in those balls
    std::vector<PairBin> bins;
};

/// Two spheres that touch, `first` being below `second`.
struct SphereContact
{
    std::uint32_t first = 0; ///< index among the spheres of the analysis
    std::uint32_t second = 0;
    double gap = 0; ///< [mesh unit] negative where they overlap
    /// [weight of a sphere of mean volume] on `first`, if AnalysisSettings asks for forces
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
};

/// Sphere k is entry k of each list.
struct ContactStatistics
{
    std::vector<SphereContact> network; ///< ascending
    std::vector<std::uint32_t> spheres; ///< other spheres that it touches
    std::vector<std::uint32_t> walls;   ///< pieces of wall that it touches
    std::vector<std::uint8_t> rattler;  ///< 1: what is left of its contacts does not hold it
    double mean = 0;                    ///< contacts with spheres, of all
    double meanInside = 0;              ///< of those away from walls and surface; NaN if none are
    double meanHeld = 0;                ///< among those that are no rattlers; NaN if there are none
    std::size_t rattlers = 0;
    double unbalance = 0; ///< [own weight] that forces miss on a sphere, at most
};

enum class CellKind : std::uint8_t
{
    whole,  ///< it lies within the object
    atWall, ///< a wall cuts it
    open,   ///< it is larger than anything within a packing: a free surface, a hole
    none,   ///< another sphere has covered it
};

/// Voronoi cells; of spheres of several sizes those by power distances, which the planes of
/// contact bound [Aurenhammer 1987]. Statistics are of whole cells.
struct CellStatistics
{
    std::vector<CellKind> kinds;   ///< [#S]
    std::vector<double> volumes;   ///< [#S] [unit^3]; NaN unless whole
    std::vector<double> fractions; ///< [#S] volume of the sphere over that of its cell; likewise
    std::size_t whole = 0;
    std::size_t atWall = 0;
    std::size_t open = 0;
    double fraction = 0; ///< of all whole cells together; NaN without any
};

/// Q6 [Steinhardt et al. 1983], of the bonds of each sphere. 0 without bonds.
struct OrderStatistics
{
    std::vector<double> q6;           ///< [#S]
    std::vector<std::uint32_t> bonds; ///< [#S]
    std::size_t inside = 0;           ///< spheres away from walls and surface: means are theirs
    double mean = 0;                  ///< of q6; NaN if none is inside
    double global = 0;                ///< Q6 of all their bonds together; likewise
};

/// A row of a profile of sizes, of the spheres whose centre is between two distances.
struct SizeBin
{
    double from = 0;
    double to = 0;
    std::size_t spheres = 0;
    double meanRadius = 0; ///< [mesh unit]
    double deviation = 0;  ///< [mesh unit] standard deviation of the radii
};

struct SizeProfiles
{
    std::vector<SizeBin> height; ///< from the foot of the object
    std::vector<SizeBin> radial; ///< from the axis
    /// [1] Pearson's correlation of radius and place; NaN for equal spheres.
    double withHeight = 0;
    double withRadial = 0;
};

struct PorosityProfiles
{
    /// Slabs that the surface does not cut are closed forms: unless the mesh crosses itself.
    bool slabsAreExact = false;
    std::vector<PorosityBin> height;
    std::vector<PorosityBin> radial;
    std::vector<PorosityBin> wall;   ///< from the wall, up to the range
    PorosityBin whole;               ///< all of the bed, sampled
    std::optional<PorosityBin> bulk; ///< see bulkInWords(), if there is any
};

/// "bulk: 4 r from the walls and from the surface, ...": what `fill` calls the bulk, too.
[[nodiscard]] const char* bulkInWords();

/// The analyses that were asked for; the others are empty. All describe the bed: the part of the
/// mesh below the surface.
struct PackingAnalysis
{
    AnalysisSettings settings;
    std::vector<std::uint32_t> ids;       ///< [#S] place in the file of each sphere that counts
    std::vector<Eigen::Vector3d> centres; ///< [#S] [mesh unit]
    std::vector<double> radii;            ///< [#S] [mesh unit]
    std::vector<double> wallDistances;    ///< [#S] [mesh unit] of the centre
    std::vector<double> depths;           ///< [#S] [mesh unit] of the centre below the surface
    double largestRadius = 0;             ///< [mesh unit]
    std::size_t outside = 0;              ///< spheres left out: their centre is outside the mesh
    std::size_t notFinite = 0;            ///< spheres left out: their place is no number
    double meshVolume = 0;                ///< [unit^3] of the interior
    double sphereVolume = 0;              ///< [unit^3]

    [[nodiscard]] bool isInBulk(std::size_t k) const;

    std::optional<PorosityProfiles> porosity;
    std::optional<PairCorrelation> pairs;
    std::optional<ContactStatistics> contacts;
    std::optional<CellStatistics> cells;
    std::optional<OrderStatistics> order;
    std::optional<SizeProfiles> sizes;
};

/// Whether Voronoi cells are built in: voro++ was there when the library was built.
[[nodiscard]] bool hasVoronoiCells();
/// A sentence that says what to install, where they are not.
[[nodiscard]] const char* missingVoronoiCells();

/// Analyses spheres in a closed, outward mesh, in O(#S log #T) but for the samples. Throws Error
/// usage for settings out of range, badData for radii that are not above 0, for lists of different
/// lengths and when no centre is inside, missingProgram when cells are asked for by name and are
/// not built in.
[[nodiscard]] PackingAnalysis analysePacking(const TriangleMesh& mesh, const Packing& packing,
                                             const AnalysisSettings& settings = {});

/// Throws Error cannotCreate, with what to do instead, if a folder holds an analysis, or a run.
void refuseToReplaceAnalysis(const std::filesystem::path& folder, const char* instead);

/// Writes a table of each analysis, spheres.csv and spheres.vtp with a column for each value of a
/// sphere, network.vtp with a line for each contact, and summary.json, all into a folder that it
/// creates. Returns their names. Throws Error cannotCreate or writeFailed.
std::vector<std::string> writeAnalysis(const PackingAnalysis& analysis,
                                       const std::filesystem::path& folder);

/// The text of summary.json.
[[nodiscard]] std::string analysisSummary(const PackingAnalysis& analysis);

} // namespace frostfill
#pragma GCC visibility pop
