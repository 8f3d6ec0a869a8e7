// SPDX-License-Identifier: MIT
#include "fps/picture_timing.hpp"

#include "image/png_bands.hpp"
#include "run/recording.hpp"

#include <frostfill/error.hpp>
#include <frostfill/image.hpp>
#include <frostfill/simulation.hpp>

#include <algorithm>
#include <chrono>
#include <optional>

namespace frostfill
{
namespace
{

/// The step in the middle of each set. Runs are repeatable, so a first one tells.
std::vector<std::uint64_t> middleSteps(const Scene& scene, const TriangleMesh& mesh)
{
    Simulation simulation(scene, mesh);
    while (simulation.step())
    {
    }
    std::vector<std::uint64_t> middles;
    std::uint64_t begin = 0;
    for (const SetRecord& set : simulation.sets())
    {
        middles.push_back(begin + (set.steps + 1) / 2);
        begin += set.steps;
    }
    return middles;
}

/// Pictures of consecutive steps in the middle of a set.
constexpr std::uint64_t kNotCounted = 2;
constexpr std::uint64_t kCounted = 8;

} // namespace

class PictureTiming::Clock
{
public:
    Clock(const TriangleMesh& mesh, const Scene& scene) : whole_(mesh, renderSettings(scene))
    {
        // The same pictures with less in them tell what costs how much. The legend stays: without
        // it the object would be drawn larger.
        RenderSettings less = renderSettings(scene);
        less.style.shell = false;
        noShell_.emplace(mesh, less);
        less.samples = 1;
        spheres_.emplace(mesh, less);
        try
        {
            RenderSettings other = renderSettings(scene);
            other.backend = Backend::osmesa;
            osmesa_.emplace(mesh, other);
        }
        catch (const Error& error)
        {
            if (error.code() != ErrorCode::noOpenGl)
            {
                throw;
            }
            withoutOsmesa_ = error.what();
        }
    }

    PictureMs draw(const Simulation& simulation)
    {
        simulation.capture(snapshot_);
        PictureMs picture;
        picture.spheres = drawing(*spheres_);
        picture.samples = drawing(*noShell_);
        const double readBefore = whole_.times()[Stage::readback];
        const Image* image = nullptr;
        picture.render = drawing(whole_, &image);
        picture.readback = 1000 * (whole_.times()[Stage::readback] - readBefore);
        const auto start = std::chrono::steady_clock::now();
        static_cast<void>(encoder_.encode(*image, {}, whole_.changedRows()));
        picture.encode =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count();
        if (osmesa_)
        {
            const double before = osmesa_->times()[Stage::readback];
            const Image* other = nullptr;
            picture.osmesa = drawing(*osmesa_, &other);
            picture.osmesa += 1000 * (osmesa_->times()[Stage::readback] - before);
            apart_ = std::max(apart_, compareImages(*image, *other).rootMeanSquare);
        }
        return picture;
    }
    [[nodiscard]] std::size_t running() const { return snapshot_.running; }
    [[nodiscard]] double apart() const { return apart_; }
    [[nodiscard]] const std::string& withoutOsmesa() const { return withoutOsmesa_; }
    [[nodiscard]] const std::string& description() const { return whole_.description(); }

private:
    /// Draws, and returns how long that took [ms].
    double drawing(Renderer& renderer, const Image** image = nullptr)
    {
        const double before = renderer.times()[Stage::rendering];
        const Image& drawn = renderer.draw(snapshot_);
        if (image)
        {
            *image = &drawn;
        }
        return 1000 * (renderer.times()[Stage::rendering] - before);
    }

    Renderer whole_;
    std::optional<Renderer> noShell_;
    std::optional<Renderer> spheres_;
    std::optional<Renderer> osmesa_;
    double apart_ = 0; ///< of 255
    std::string withoutOsmesa_;
    PngBands encoder_;
    Snapshot snapshot_;
};

PictureTiming::PictureTiming(const Scene& scene, const TriangleMesh& mesh)
    : mesh_(mesh), clock_(std::make_unique<Clock>(mesh, scene))
{
}

PictureTiming::~PictureTiming() = default;

const std::string& PictureTiming::description() const
{
    return clock_->description();
}

FpsPictures PictureTiming::timeRun(const Scene& scene)
{
    const std::vector<std::uint64_t> middles = middleSteps(scene, mesh_);
    Simulation simulation(scene, mesh_);
    FpsPictures pictures;
    double running = 0;
    for (const std::uint64_t middle : middles)
    {
        while (simulation.steps() < middle && simulation.step())
        {
        }
        for (std::uint64_t i = 0; i < kNotCounted; ++i)
        {
            static_cast<void>(clock_->draw(simulation));
            simulation.step();
        }
        PictureMs sum;
        for (std::uint64_t i = 0; i < kCounted; ++i)
        {
            sum += clock_->draw(simulation);
            running += static_cast<double>(clock_->running());
            simulation.step();
        }
        pictures.sets.push_back(sum.over(kCounted));
        pictures.mean += pictures.sets.back();
    }
    const double count = std::max(1.0, static_cast<double>(pictures.sets.size()));
    pictures.mean = pictures.mean.over(count);
    pictures.running = running / (count * kCounted);
    pictures.apart = clock_->apart();
    pictures.withoutOsmesa = clock_->withoutOsmesa();
    return pictures;
}

} // namespace frostfill
