// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "page/assemble.hpp"
#include "run_file/file_of_run.hpp"
#include "run_file/frame_codec.hpp"
#include "shell/simplified_shell.hpp"

#include <frostfill/error.hpp>
#include <frostfill/page.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

namespace frostfill
{
namespace
{

/// Frames that are longer than so many pages before they are packed are not worth packing: they
/// shrink to a third or so.
constexpr double kGiveUpFactor = 12;

/// Steps of the grid in the smallest radius, at least: an error of a thousandth of it is a pixel
/// where a sphere is two thousand pixels wide.
constexpr double kStepsPerRadius = 500;

std::string textOf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Reads a run once for its size and then frame by frame.
class PageMaker
{
public:
    PageMaker(const PageRequest& request, const std::filesystem::path& file,
              const PageProgress& progress)
        : request_(request), progress_(progress), reader_(file),
          head_(readHead(reader_.head(), file.string())), view_(pageView(head_, reader_.mesh())),
          shell_(simplifyShell(reader_.mesh(), request.fullMesh))
    {
        requireFrames(reader_, file);
        fastest_ = fastestColour(head_, view_);
        shape_ = shapeSections(shell_.mesh, view_.framing);
        sets_ = textOf(file.parent_path() / "sets.csv");
        findSmallestRadius();
        rounding_ = {gridOf(smallest_, kStepsPerRadius), false, fastest_};
    }

    std::string page(PageResult& result)
    {
        const std::size_t last = reader_.frames().size() - 1;
        result.keptFrames = reader_.frames().size();
        result.ended = reader_.summary().has_value();
        result.spheres = spheres_;
        result.error = rounding_.grid / 2;
        result.errorOverRadius = result.error / smallest_;
        result.shell = shell_.facts;

        std::string whole = pageOf(0, last, result);
        if (!whole.empty() && whole.size() <= request_.maxBytes)
        {
            return whole;
        }
        result.motionBytes = whole.size();
        whole = last > 0 ? pageOf(last, last, result) : whole;
        if (whole.size() > request_.maxBytes)
        {
            throw Error(ErrorCode::usage,
                        fmt::format("a page of the last frame alone takes {:.3g} MB; give "
                                    "--max-size {:.0f} or more",
                                    static_cast<double>(whole.size()) / 1e6,
                                    std::ceil(static_cast<double>(whole.size()) / 1e6)));
        }
        return whole;
    }

private:
    void findSmallestRadius()
    {
        std::ignore = reader_.seek(reader_.frames().size() - 1);
        spheres_ = reader_.radii().size();
        for (const double radius : reader_.radii())
        {
            smallest_ = std::min(smallest_, radius);
        }
        smallest_ = spheres_ > 0 ? smallest_ : 1;
    }

    [[nodiscard]] SphereRecord sphere(std::uint32_t id) const
    {
        SphereRecord sphere;
        sphere.centre = reader_.centres()[id];
        sphere.radius = reader_.radii()[id];
        return sphere;
    }

    /// The page with frames first..last; empty if it is hopelessly large.
    std::string pageOf(std::size_t first, std::size_t last, PageResult& result)
    {
        FrameEncoder film(rounding_, boundingBox(reader_.mesh()).center(),
                          shell_.mesh.triangles.size());
        std::vector<PolygonState> polygons;
        std::vector<std::size_t> numbers;
        std::optional<std::uint64_t> revision;
        for (std::size_t i = first; i <= last; ++i)
        {
            const Snapshot& state = reader_.seek(i);
            numbers.push_back(reader_.frames()[i]);
            if (revision == reader_.revision())
            {
                film.repeat();
            }
            else
            {
                showPolygons(shell_, state.polygons, polygons);
                film.encode(
                    state, [&](std::uint32_t id) { return sphere(id); }, polygons);
            }
            revision = reader_.revision();
            reader_.forgetChanges();
            if (static_cast<double>(film.bytes()) >
                    kGiveUpFactor * static_cast<double>(request_.maxBytes) &&
                last > first)
            {
                return {};
            }
            if (progress_ && !progress_(i - first + 1, last - first + 1))
            {
                throw Error(ErrorCode::stoppedEarly,
                            "the page was not written; give the same command again");
            }
        }
        result.frames = numbers.size();
        return assemble(film, numbers, result.keptFrames);
    }

    std::string assemble(FrameEncoder& film, const std::vector<std::size_t>& numbers,
                         std::size_t kept)
    {
        nlohmann::ordered_json facts =
            pageFacts(reader_, head_, view_, shell_, film.snapshot().columns, sets_);
        facts["film"] = {
            {"step", rounding_.grid},
            {"radius_step", rounding_.radiusStep()},
            {"error_over_radius", rounding_.grid / 2 / smallest_},
            {"fastest", fastest_},
            {"spheres", spheres_},
            {"frames", numbers},
            {"kept", kept},
            {"columns", {{"radius", "never"}, {"group", "never"}, {"speed", "running"}}},
            {"carried", nlohmann::ordered_json::object()}};
        for (const ColumnValues& values : film.snapshot().columns)
        {
            const Column& column = values.column();
            facts["film"]["carried"][column.name] = {{"stream", streamOf(column)},
                                                     {"whole", column.isWhole()}};
        }
        Sections sections = shape_;
        for (const auto& [name, stream] : film.take())
        {
            sections.emplace_back(name, stream.bytes());
        }
        return assemblePage(std::move(facts), sections);
    }

    const PageRequest& request_;
    const PageProgress& progress_;
    RunFileReader reader_;
    RunHead head_;
    PageView view_;
    SimplifiedShell shell_;
    double fastest_ = 0;
    Rounding rounding_;
    double smallest_ = std::numeric_limits<double>::infinity();
    std::size_t spheres_ = 0;
    Sections shape_;
    std::string sets_;
};

} // namespace

PageResult writePage(const PageRequest& request, const PageProgress& progress)
{
    const std::filesystem::path run = fileOfRun(request.run);
    PageResult result;
    result.file = request.file.empty() ? run.parent_path() / kPageFile : request.file;
    if (!request.overwrite && std::filesystem::exists(std::filesystem::symlink_status(result.file)))
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("'{}' is there already; give --overwrite, or another --out",
                                result.file.string()));
    }
    PageMaker maker(request, run, progress);
    AtomicFile file(result.file); // whether it can be written is better known before the work
    const std::string page = maker.page(result);
    file.write(page);
    file.commit();
    result.bytes = page.size();
    return result;
}

} // namespace frostfill
