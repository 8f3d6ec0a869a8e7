// SPDX-License-Identifier: MIT
#include "base/processor_time.hpp"
#include "run/run_length.hpp"
#include "sweep/trial.hpp"

#include <frostfill/plan.hpp>
#include <frostfill/plan_fill.hpp>
#include <frostfill/simulation.hpp>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace frostfill
{
namespace
{

/// Spheres of a run that is tried itself, and of the larger model of one that is not. More: plans
/// take longer. Fewer: what a run takes beside its spheres counts for too much.
constexpr double kTried = 2000;
/// The larger model has this many times as many spheres as the smaller one.
constexpr double kApart = 4;
/// Pictures of a trial. More: plans take longer.
constexpr std::size_t kPictures = 24;
constexpr std::size_t kFewPictures = 4;
/// [bytes] of a sphere in memory, with what is measured and written at the end.
constexpr double kBytesPerSphere = 250;

/// A folder of its own that goes with its owner.
class Scratch
{
public:
    Scratch()
    {
        std::string name = (std::filesystem::temp_directory_path() / "frostfill-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
        {
            throw Error(ErrorCode::cannotCreate, "cannot create a temporary folder " + name +
                                                     "; TMPDIR can name another place");
        }
        path_ = name;
    }
    ~Scratch()
    {
        std::error_code none;
        std::filesystem::remove_all(path_, none);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

double peakMemory()
{
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

double bytesIn(const std::filesystem::path& folder)
{
    double bytes = 0;
    std::error_code none;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none))
    {
        bytes += entry.is_regular_file() ? static_cast<double>(entry.file_size()) : 0;
    }
    return bytes;
}

/// What a run with so many pictures at most takes.
Trial tryRun(const Scene& scene, std::size_t pictures)
{
    const Scratch scratch;
    FillRequest request;
    request.scene = scene;
    request.scene.threads = 1;
    request.scene.frames.limit = pictures;
    request.directory = scratch.path() / "run";
    const double before = ProcessorClock::now();
    const FillResult result = fill(request);
    Trial trial;
    trial.time.before = ProcessorClock::now() - before;
    trial.spheres = static_cast<double>(std::max<std::size_t>(1, result.spheres));
    const double drawn = bytesIn(request.directory / "frames");
    trial.pictureBytes = drawn / static_cast<double>(std::max<std::size_t>(1, result.frames));
    trial.otherBytes = bytesIn(request.directory) - drawn;
    return trial;
}

/// The same with the time of its pictures apart: by what some more of them take.
Trial tryRun(const Scene& scene)
{
    if (!scene.frames.enabled)
    {
        return tryRun(scene, kPictures);
    }
    const Trial few = tryRun(scene, kFewPictures);
    Trial trial = tryRun(scene, kPictures);
    trial.time = timesOf(few.time.before, kFewPictures, trial.time.before, kPictures);
    return trial;
}

Cost costOf(const Scene& scene)
{
    const Scratch scratch;
    FillRequest request;
    request.scene = scene;
    request.directory = scratch.path() / "run";
    const FillPlan plan = planFill(request);
    const auto spheres = static_cast<double>(std::max<std::size_t>(1, plan.spheres));
    const TriangleMesh mesh = loadMesh(scene.object.mesh, scene.object.load).mesh;
    const Simulation simulation(scene, mesh);
    const double factor = std::max(1.0, std::cbrt(spheres / kTried));
    const Trial trial = tryRun(factor > 1 ? modelOf(scene, simulation, factor) : scene);
    std::optional<Trial> smaller;
    if (factor > 1)
    {
        smaller = tryRun(modelOf(scene, simulation, factor * std::cbrt(kApart)));
    }
    Cost cost = costFrom(trial, smaller, spheres, static_cast<double>(plan.frames));
    cost.memory = peakMemory() + kBytesPerSphere * spheres;
    return cost;
}

} // namespace

PictureTimes timesOf(double fewSeconds, double few, double manySeconds, double many)
{
    const double each = many > few ? std::max(0.0, manySeconds - fewSeconds) / (many - few)
                                   : manySeconds / std::max(1.0, many);
    return {std::max(0.0, fewSeconds - few * each), each};
}

Cost costFrom(const Trial& trial, const std::optional<Trial>& smaller, double spheres,
              double pictures)
{
    double seconds = trial.time.before;
    if (smaller)
    {
        const double power = std::log(seconds / smaller->time.before) /
                             std::log(std::max(1.1, trial.spheres / smaller->spheres));
        seconds *= std::pow(spheres / trial.spheres, std::clamp(power, kMinPower, kLargestPower));
    }
    Cost cost;
    cost.seconds = seconds + pictures * trial.time.each;
    cost.bytes =
        pictures * trial.pictureBytes + trial.otherBytes * std::max(1.0, spheres / trial.spheres);
    return cost;
}

std::vector<Cost> planSweep(const std::vector<SweepRun>& runs)
{
    std::map<std::string, Cost> known; // another seed changes little
    std::vector<Cost> costs;
    for (const SweepRun& run : runs)
    {
        Scene scene = run.scene;
        scene.seed = Scene{}.seed;
        const std::string setting = sceneToToml(scene);
        auto found = known.find(setting);
        if (found == known.end())
        {
            found = known.emplace(setting, Cost{}).first;
            try
            {
                found->second = costOf(scene);
            }
            catch (const Error& error)
            {
                found->second.failure = error.what();
            }
        }
        costs.push_back(found->second);
    }
    return costs;
}

RenderPlan planRender(const RenderRequest& request)
{
    RenderRequest part = request;
    part.dryRun = true;
    part.shard = {};
    const Scratch nowhere; // that pictures are in the usual place already is no matter
    part.directory = nowhere.path() / "pictures";
    RenderPlan plan;
    plan.pictures = renderRun(part).allFrames;
    part.dryRun = false;
    part.overwrite = false;
    part.contactSheet = false;
    part.video.clear();
    // Some from the middle, as one process draws them one after the other; and one.
    const auto draw = [&](std::size_t pictures, double& bytes)
    {
        const Scratch scratch;
        part.directory = scratch.path() / "pictures";
        const std::size_t parts = std::max<std::size_t>(1, plan.pictures / pictures);
        part.shard = {parts / 2, parts};
        const double before = ProcessorClock::now();
        const std::size_t drawn = renderRun(part).frames;
        const double seconds = ProcessorClock::now() - before;
        bytes = bytesIn(part.directory) / static_cast<double>(std::max<std::size_t>(1, drawn));
        return std::pair(seconds, static_cast<double>(drawn));
    };
    const auto [one, first] = draw(1, plan.bytesPerPicture);
    const auto [many, pictures] = draw(kPictures, plan.bytesPerPicture);
    const PictureTimes times = timesOf(one, first, many, pictures);
    plan.secondsPerPicture = times.each;
    plan.secondsBefore = times.before;
    plan.memory = peakMemory();
    return plan;
}

} // namespace frostfill
