// SPDX-License-Identifier: MIT
#include "study/frame_recorder.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

RenderSettings renderSettings(const Scene& scene, std::vector<Pose> poses)
{
    RenderSettings settings;
    settings.poses = std::move(poses);
    settings.size = scene.size;
    settings.camera = scene.camera;
    settings.style = scene.style;
    settings.samples = scene.samples;
    settings.up = upVector(scene.object.up);
    settings.title = scene.name;
    return settings;
}

bool allPixelsAlike(const Image& image)
{
    const auto channels = static_cast<std::ptrdiff_t>(image.channels);
    return std::equal(image.pixels.begin() + channels, image.pixels.end(), image.pixels.begin());
}

} // namespace

FrameRecorder::FrameRecorder(const TriangleMesh& mesh, const Scene& scene, double interval,
                             const std::filesystem::path& directory, std::vector<Pose> poses)
    : mesh_(mesh), settings_(renderSettings(scene, std::move(poses))),
      renderer_(std::make_unique<Renderer>(mesh, settings_)),
      sequence_(directory, scene.frames.limit, {{"Software", "Frostfill"}, {"Title", scene.name}}),
      description_(renderer_->description()), interval_(interval)
{
}

void FrameRecorder::record(const Simulation& simulation)
{
    // A step may be longer than the time between frames: then several frames show it.
    while (simulation.time() >= static_cast<double>(next_) * interval_)
    {
        if (sequence_.wants(next_))
        {
            draw(simulation);
            put(next_);
        }
        ++next_;
    }
}

void FrameRecorder::finish(const Simulation& simulation)
{
    if (drawnStep_ != simulation.steps())
    {
        draw(simulation);
        // Thinning may double the stride under our hands; the last state has to survive it.
        do
        {
            const std::size_t stride = sequence_.stride();
            next_ = (next_ + stride - 1) / stride * stride;
            put(next_);
        } while (!sequence_.wants(next_));
    }
    // With a legend no picture is blank, so the look is at a small one without. The first context
    // is closed before: there is never more than one.
    if (snapshot_.centres.empty())
        return;
    renderTimes_ = renderer_->times();
    renderer_.reset();
    RenderSettings small = settings_;
    small.style.legend = false;
    small.samples = 1;
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
    if (drawnStep_ == simulation.steps())
        return;
    simulation.capture(snapshot_);
    drawnStep_ = simulation.steps();

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
    const StageTimes before = sequence_.times();
    sequence_.put(number, image_);
    const StageTimes& after = sequence_.times();
    sets_[snapshot_.set].encodeMs.push_back(1000 *
                                            (after[Stage::encoding] - before[Stage::encoding]));
}

} // namespace frostfill
