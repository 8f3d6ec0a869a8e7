// SPDX-License-Identifier: MIT
#include "study/frame_recorder.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

RenderSettings renderSettings(const Scene& scene, const ColourRange& range)
{
    RenderSettings settings;
    settings.size = scene.size;
    settings.camera = scene.camera;
    settings.style = scene.style;
    settings.samples = scene.samples;
    settings.supersample = scene.supersample;
    settings.backend = scene.backend;
    settings.range = range;
    settings.groupsPerSet = scene.spheres.groupsPerSet;
    settings.unitsPerMetre = scene.object.unitsPerMetre;
    settings.up = upVector(scene.object.up);
    settings.title = scene.name;
    return settings;
}

namespace
{

bool allPixelsAlike(const Image& image)
{
    const auto channels = static_cast<std::ptrdiff_t>(image.channels);
    return std::equal(image.pixels.begin() + channels, image.pixels.end(), image.pixels.begin());
}

} // namespace

FrameRecorder::FrameRecorder(const TriangleMesh& mesh, const Scene& scene, double interval,
                             const ColourRange& range, const std::filesystem::path& directory,
                             const std::filesystem::path& video)
    : mesh_(mesh), settings_(renderSettings(scene, range)),
      renderer_(std::make_unique<Renderer>(mesh, settings_)),
      sequence_(directory / "frames", scene.frames.limit,
                {{"Software", "Frostfill"}, {"Title", scene.name}}),
      sideOutputs_(scene, directory, video), objectRegion_(renderer_->objectRegion()),
      description_(renderer_->description()), interval_(interval), frames_(scene.frames)
{
}

bool FrameRecorder::wants(std::size_t number) const
{
    return sequence_.wants(number) || sideOutputs_.wantEveryFrame();
}

double FrameRecorder::angleAt(std::size_t number) const
{
    const auto& turn = settings_.camera.turntable;
    return turn ? 360 * std::fmod(static_cast<double>(number) / (frames_.fps * *turn), 1.0) : 0;
}

void FrameRecorder::record(const Simulation& simulation)
{
    // A step may be longer than the time between frames: then several frames show it.
    while (simulation.time() >= static_cast<double>(next_) * interval_)
    {
        if (wants(next_))
        {
            draw(simulation);
            put(next_);
        }
        ++next_;
    }
}

void FrameRecorder::hold(const Simulation& simulation)
{
    const auto end = next_ + static_cast<std::size_t>(std::llround(frames_.hold * frames_.fps));
    for (; next_ < end; ++next_)
    {
        if (wants(next_))
        {
            draw(simulation);
            put(next_);
        }
    }
}

void FrameRecorder::finish(const Simulation& simulation)
{
    hold(simulation);
    if (drawnStep_ != simulation.steps())
    {
        // Thinning may double the stride under our hands; the last state has to survive it.
        do
        {
            const std::size_t stride = sequence_.stride();
            next_ = (next_ + stride - 1) / stride * stride;
            draw(simulation);
            put(next_);
        } while (!sequence_.wants(next_));
    }
    videoFailure_ = sideOutputs_.finish();
    // With a legend no picture is blank, so the look is at a small one without. The first context
    // is closed before: there is never more than one.
    if (snapshot_.centres.empty())
        return;
    renderTimes_ = renderer_->times();
    renderer_.reset();
    RenderSettings small = settings_;
    small.style.legend = false;
    small.style.ambientOcclusion = false;
    small.samples = 1;
    small.supersample = 1;
    small.size.height = std::max(1, small.size.height * 160 / std::max(160, small.size.width));
    small.size.width = std::min(160, small.size.width);
    Renderer(mesh_, small).render(snapshot_, image_);
    blank_ = blank_ || allPixelsAlike(image_);
}

StageTimes FrameRecorder::times() const
{
    StageTimes times = renderer_ ? renderer_->times() : renderTimes_;
    times += sequence_.times();
    return times;
}

void FrameRecorder::draw(const Simulation& simulation)
{
    const double angle = angleAt(next_);
    if (drawnStep_ == simulation.steps() && drawnAngle_ == angle)
        return;
    simulation.capture(snapshot_);
    drawnStep_ = simulation.steps();
    drawnAngle_ = angle;
    renderer_->turn(angle);

    const StageTimes before = renderer_->times();
    renderer_->render(snapshot_, image_);
    const StageTimes& after = renderer_->times();

    if (sets_.size() <= snapshot_.set)
        sets_.resize(snapshot_.set + 1);
    SetFrames& set = sets_[snapshot_.set];
    const auto spent = [&](Stage stage) { return 1000 * (after[stage] - before[stage]); };
    set.renderMs.push_back(spent(Stage::rendering));
    set.readbackMs.push_back(spent(Stage::readback));
    blank_ = blank_ || (!snapshot_.centres.empty() && allPixelsAlike(image_));
}

void FrameRecorder::put(std::size_t number)
{
    sideOutputs_.put(number, sequence_.wants(number), *renderer_, snapshot_, image_);
    const StageTimes before = sequence_.times();
    sequence_.put(number, image_);
    const StageTimes& after = sequence_.times();
    sets_[snapshot_.set].encodeMs.push_back(1000 *
                                            (after[Stage::encoding] - before[Stage::encoding]));
}

} // namespace frostfill
