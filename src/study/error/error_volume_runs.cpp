// SPDX-License-Identifier: MIT
#include "base/processor_time.hpp"
#include "scene/packing_estimate.hpp"
#include "study/error/error_finish.hpp"
#include "study/error/error_runs.hpp"

#include <frostfill/error.hpp>
#include <frostfill/volume_estimate.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <numbers>

namespace frostfill
{
namespace
{

constexpr std::array kObjects = {"torus", "sphere", "cube", "human"};

std::string nameOf(const std::string& object)
{
    return std::filesystem::path(object).stem().string();
}

/// One object until full with spheres of one radius.
struct Filling
{
    double x = 0;         ///< r S / V
    double spheres = 0;   ///< how many fit
    double taken = 0;     ///< share of the volume that is inside them
    double corrected = 0; ///< N v / phi + c r S over V, less 1
    double seconds = 0;
};

class Fillings
{
public:
    /// Filled when asked for first.
    const Filling& at(const std::string& object, double x)
    {
        const auto key = std::pair(object, x);
        const auto found = known_.find(key);
        return found != known_.end() ? found->second
                                     : known_.emplace(key, fill(object, x)).first->second;
    }
    /// Spheres that fit, about.
    static double expected(const std::string& object, double x)
    {
        const MeshReport report = inspectMesh(loadMesh(object).mesh);
        const double radius = x * report.volume / report.area;
        return kPackingFraction * (1 - kWallLayer * x) * report.volume /
               (4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3));
    }
    static Scene sceneFor(const std::string& object)
    {
        Scene scene = studyScene(Preset::fast, object, 1);
        scene.motion.mode = Motion::skip;
        return scene;
    }

private:
    static Filling fill(const std::string& object, double x)
    {
        const TriangleMesh mesh = loadMesh(object).mesh;
        const MeshReport report = inspectMesh(mesh);
        Scene scene = sceneFor(object);
        scene.spheres.radius = x * report.volume / report.area;
        const Finished run = finishRun(scene, mesh);
        const double truth = run.quality.meshVolume;
        return {x, static_cast<double>(run.world->spheres.size()), run.quality.sphereVolume / truth,
                run.quality.volumeEstimate / truth - 1, run.seconds};
    }

    std::map<std::pair<std::string, double>, Filling> known_;
};

ErrorPoint volumePoint(const std::string& object, const char* way, const Filling& filling,
                       double error, double seconds)
{
    return {"volume",
            way,
            fmt::format("{}, rS/V {:.3g}", nameOf(object), filling.x),
            false,
            seconds,
            std::abs(error),
            {filling.x, filling.spheres, error, filling.taken},
            false,
            nameOf(object)};
}

void addFilling(std::vector<ErrorTask>& tasks, const std::shared_ptr<Fillings>& fillings,
                const std::string& object, double x, bool finer)
{
    tasks.emplace_back(
        [=]
        {
            const Filling& one = fillings->at(object, x);
            return volumePoint(object, "raw", one, one.taken - 1, one.seconds);
        });
    tasks.emplace_back(
        [=]
        {
            const Filling& one = fillings->at(object, x);
            return volumePoint(object, "wall-corrected", one, one.corrected, one.seconds);
        });
    if (finer)
    {
        tasks.emplace_back(
            [=]
            {
                const Filling& one = fillings->at(object, x);
                const Filling& half = fillings->at(object, x / 2);
                const double phi = packingCalibration(Fillings::sceneFor(object)).ruleFraction;
                return volumePoint(object, "two radii", one, (2 * half.taken - one.taken) / phi - 1,
                                   one.seconds + half.seconds);
            });
    }
}

/// What --estimate-volume does when it is told nothing else.
ErrorPoint defaultEstimate(const std::string& object)
{
    Scene scene = Fillings::sceneFor(object);
    scene.spheres.radius.reset();
    scene.spheres.count = 1; // it chooses its own
    const ProcessorClock clock;
    const VolumeEstimate estimate = estimateVolume(scene);
    Filling filling;
    filling.x = estimate.radiusTimesAreaOverVolume;
    filling.spheres = static_cast<double>(estimate.fine);
    ErrorPoint point = volumePoint(object, "two radii", filling,
                                   estimate.volume / estimate.meshVolume - 1, clock.seconds());
    point.setting = nameOf(object) + ", --estimate-volume";
    point.isDefault = true;
    return point;
}

} // namespace

void addVolumeRuns(std::vector<ErrorTask>& tasks, const std::vector<std::string>& more, bool quick)
{
    constexpr double kCoarsest = 0.6;
    constexpr double kMaxWhenQuick = 6e4;
    const double most = quick ? 8e3 : 1.1e5;
    const double mostInCube = quick ? most : 1.7e6;
    const auto fillings = std::make_shared<Fillings>();
    std::vector<std::string> objects(kObjects.begin(), kObjects.end());
    objects.insert(objects.end(), more.begin(), more.end());
    for (const std::string& object : objects)
    {
        const double limit = object == "cube" ? mostInCube : most;
        for (int k = 0; k < 12; ++k)
        {
            // Halves of the radii occur again, for the estimate from two.
            const double x =
                kCoarsest * std::ldexp(k % 2 == 0 ? 1.0 : std::numbers::sqrt2 / 2, -(k / 2));
            if (Fillings::expected(object, x) > limit)
            {
                break;
            }
            addFilling(tasks, fillings, object, x, Fillings::expected(object, x / 2) <= limit);
        }
        // It takes a run with half of a fifth of V/S.
        if (!quick || Fillings::expected(object, 0.1) <= kMaxWhenQuick)
        {
            tasks.emplace_back([=] { return defaultEstimate(object); });
        }
    }
}

} // namespace frostfill
