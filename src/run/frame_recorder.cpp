// SPDX-License-Identifier: MIT
#include "run/frame_recorder.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace frostfill
{

RenderSettings renderSettings(const Scene& scene, const ColourRange& range, std::vector<Pose> poses)
{
    RenderSettings settings;
    settings.poses = std::move(poses);
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
    settings.staticLayer = scene.staticLayer;
    return settings;
}

namespace
{

/// Fewer pixels than that may show nothing but the object's colour, and are not looked at.
constexpr int kFewPixels = 64;

/// Of the small picture in which spheres are looked for.
constexpr int kLookWidth = 160;

bool allPixelsAlike(const Image& image)
{
    const auto channels = static_cast<std::ptrdiff_t>(image.channels);
    return std::equal(image.pixels.begin() + channels, image.pixels.end(), image.pixels.begin());
}

} // namespace

FrameRecorder::FrameRecorder(const TriangleMesh& mesh, const Scene& scene, double interval,
                             const ColourRange& range, const std::filesystem::path& directory,
                             const std::string& run, const std::filesystem::path& video,
                             std::vector<Pose> poses)
    : mesh_(mesh), settings_(renderSettings(scene, range, std::move(poses))),
      selection_(FrameSelection::parse(scene.frames.selection).value()),
      thinning_(scene.frames.limit), frames_(scene.frames), interval_(interval),
      writer_(directory / "frames", scene.frames.limit,
              {{"Software", "Frostfill"}, {"Title", scene.name}, {"Run", run}}),
      sideOutputs_(scene, directory, video)
{
    // A context belongs to the thread that draws with it.
    drawing_.push([this] { renderer_ = std::make_unique<Renderer>(mesh_, settings_); });
    drawing_.finish();
    description_ = renderer_->description();
    objectRegion_ = renderer_->objectRegion();
}

FrameRecorder::~FrameRecorder()
{
    try
    {
        closeRenderer();
    }
    catch (...)
    {
        // Whoever finishes hears of it; here is nobody left to tell.
    }
}

void FrameRecorder::closeRenderer()
{
    drawing_.push([this] { renderer_.reset(); });
    drawing_.finish();
}

bool FrameRecorder::wants(std::size_t number) const
{
    return thinning_.wants(number) || sideOutputs_.wantEveryFrame();
}

double FrameRecorder::angleAt(std::size_t frame) const
{
    const auto& turn = settings_.camera.turntable;
    return turn ? 360 * std::fmod(static_cast<double>(frame) / (frames_.fps * *turn), 1.0) : 0;
}

void FrameRecorder::takeNext(const Simulation& simulation)
{
    if (selection_.has(next_))
    {
        if (wants(selected_))
        {
            take(simulation, selected_);
        }
        ++selected_;
    }
    ++next_;
}

void FrameRecorder::record(const Simulation& simulation)
{
    // A step may be longer than the time between frames: then several frames show it.
    while (simulation.time() >= static_cast<double>(next_) * interval_ && !stops())
    {
        takeNext(simulation);
    }
}

void FrameRecorder::take(const Simulation& simulation, std::size_t number)
{
    Order order;
    order.angle = angleAt(next_);
    order.isNew = takenStep_ != simulation.steps() || takenAngle_ != order.angle;
    if (takenStep_ != simulation.steps())
    {
        // With one job at most waiting and one being done, the third snapshot is free.
        newest_ = (newest_ + 1) % snapshots_.size();
        simulation.capture(snapshots_[newest_]);
    }
    takenStep_ = simulation.steps();
    takenAngle_ = order.angle;
    order.snapshot = &snapshots_[newest_];
    order.number = number;
    order.frame = next_;
    // A picture at which thinning begins may fall to it itself: the passes have to hear of it.
    order.keep = thinning_.wants(number);
    thinning_.take(number);
    drawing_.push([this, order] { draw(order); });
}

void FrameRecorder::draw(const Order& order)
{
    const Snapshot& snapshot = *order.snapshot;
    if (order.isNew)
    {
        renderer_->turn(order.angle);
        const StageTimes before = renderer_->times();
        image_ = &renderer_->draw(snapshot);
        const StageTimes& after = renderer_->times();
        if (sets_.size() <= snapshot.set)
        {
            sets_.resize(snapshot.set + 1);
        }
        const auto spent = [&](Stage stage) { return 1000 * (after[stage] - before[stage]); };
        sets_[snapshot.set].renderMs.push_back(spent(Stage::rendering));
        sets_[snapshot.set].readbackMs.push_back(spent(Stage::readback));
        blank_ =
            blank_ || (!snapshot.centres.empty() && image_->width * image_->height >= kFewPixels &&
                       allPixelsAlike(*image_));
    }
    noRows_.assign(static_cast<std::size_t>(image_->height), 0);
    writer_.put(order.number, *image_, order.isNew ? renderer_->changedRows() : noRows_,
                snapshot.set,
                {{"Frame", fmt::format("{}", order.frame)},
                 {"Time", fmt::format("{:.9g} s", snapshot.time)}});
    sideOutputs_.put(order.number, order.keep, *renderer_, snapshot, *image_);
}

void FrameRecorder::finish(const Simulation& simulation)
{
    const auto end = next_ + static_cast<std::size_t>(std::llround(frames_.hold * frames_.fps));
    while (next_ < end && !stops())
    {
        takeNext(simulation);
    }
    if (selection_.hasLast() && takenStep_ != simulation.steps())
    {
        // Thinning may double the stride under our hands; the last state has to survive it.
        do
        {
            const std::size_t stride = thinning_.stride();
            selected_ = (selected_ + stride - 1) / stride * stride;
            take(simulation, selected_);
        } while (!thinning_.wants(selected_));
    }
    const Snapshot& last = snapshots_[newest_];
    drawing_.push(
        [this, &last]
        {
            videoFailure_ = sideOutputs_.finish();
            times_ = renderer_->times();
            renderer_.reset();
            if (!last.centres.empty())
            {
                lookForSpheres(last);
            }
        });
    drawing_.finish();
    writer_.finish();
    times_ += writer_.times();
    const auto& encoding = writer_.milliseconds();
    sets_.resize(std::max(sets_.size(), encoding.size()));
    for (std::size_t set = 0; set < encoding.size(); ++set)
    {
        sets_[set].encodeMs = encoding[set];
    }
}

void FrameRecorder::lookForSpheres(const Snapshot& snapshot)
{
    // With a legend no picture is blank, so the look is at a small one without. The first context
    // is closed before: there is never more than one.
    RenderSettings small = settings_;
    small.style.legend = false;
    small.style.ambientOcclusion = false;
    small.samples = 1;
    small.supersample = 1;
    small.size.height = std::clamp(kLookWidth * small.size.height / small.size.width, 8, 2560);
    small.size.width = kLookWidth;
    try
    {
        Image image;
        Renderer(mesh_, small).render(snapshot, image);
        blank_ = blank_ || allPixelsAlike(image);
    }
    catch (const Error&)
    {
        // Without memory for another context the run is no worse.
    }
}

} // namespace frostfill
