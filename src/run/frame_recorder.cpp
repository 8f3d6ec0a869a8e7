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

/// The scene's selection; of a single picture it is the last.
FrameSelection framesToDraw(const Scene& scene)
{
    const auto selection = FrameSelection::parse(scene.frames.selection).value();
    return scene.frames.limit == 1 && selection.hasLast() ? FrameSelection::parse("last").value()
                                                          : selection;
}

bool allPixelsAlike(const Image& image)
{
    const auto channels = static_cast<std::ptrdiff_t>(image.channels);
    return std::equal(image.pixels.begin() + channels, image.pixels.end(), image.pixels.begin());
}

} // namespace

FrameRecorder::FrameRecorder(const TriangleMesh& mesh, const Scene& scene, const ColourRange& range,
                             const std::filesystem::path& directory, const std::string& run,
                             const std::filesystem::path& video, std::vector<Pose> poses,
                             std::optional<CameraPath> path)
    : mesh_(mesh), settings_(renderSettings(scene, range, std::move(poses))),
      selection_(framesToDraw(scene)), thinning_(scene.frames.limit), frames_(scene.frames),
      path_(std::move(path)), held_(heldFrames(scene, path_ ? path_->duration() : 0)),
      writer_(directory / "frames", scene.frames.limit,
              {{"Software", "Frostfill"}, {"Title", scene.name}, {"Run", run}}),
      sideOutputs_(scene, directory, video)
{
    if (path_)
    {
        settings_.camera = path_->at(0, settings_.camera);
        settings_.camera.turntable = 1; // the object fits, equally large, at all angles
    }
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
    return turn && !path_ ? 360 * std::fmod(static_cast<double>(frame) / (frames_.fps * *turn), 1.0)
                          : 0;
}

void FrameRecorder::keepTo(const FramePlan& plan)
{
    interval_ = plan.timing.interval;
    thinning_.keepEvery(plan.stride);
    drawing_.push(
        [this, stride = plan.stride]
        {
            writer_.keepEvery(stride);
            sideOutputs_.keepEvery(stride);
        });
}

void FrameRecorder::takeNext(const Simulation& simulation, bool selected)
{
    if (selected)
    {
        if (wants(selected_))
        {
            take(simulation, selected_);
        }
        ++selected_;
    }
    ++next_;
}

double FrameRecorder::timeAt(std::size_t frame) const
{
    return static_cast<double>(frame) * interval_ - (falls_ ? falls_->lag() : 0);
}

void FrameRecorder::record(const Simulation& simulation)
{
    // A step may be longer than the time between frames: then several frames show it.
    while (simulation.time() >= timeAt(next_) && !stops())
    {
        takeNext(simulation, selection_.has(next_));
    }
}

void FrameRecorder::capture(const Simulation& simulation, double time)
{
    // With one job at most waiting and one being done, the third snapshot is free.
    newest_ = (newest_ + 1) % snapshots_.size();
    Snapshot& snapshot = snapshots_[newest_];
    if (falls_)
    {
        FallingSpheres::takeFrom(snapshot, real_[newest_]);
    }
    simulation.capture(snapshot);
    if (falls_)
    {
        real_[newest_] = falls_->addTo(snapshot, time);
    }
}

void FrameRecorder::take(const Simulation& simulation, std::size_t number)
{
    Order order;
    order.angle = angleAt(next_);
    const bool stands = taken_ == simulation.revision() && (!falls_ || over_);
    order.seconds =
        path_ ? std::min(static_cast<double>(next_) / frames_.fps, path_->duration()) : 0;
    order.isNew = !stands || takenAngle_ != order.angle || takenSeconds_ != order.seconds;
    if (!stands)
    {
        capture(simulation, over_ ? simulation.time() : std::min(timeAt(next_), simulation.time()));
    }
    taken_ = simulation.revision();
    takenAngle_ = order.angle;
    takenSeconds_ = order.seconds;
    order.snapshot = &snapshots_[newest_];
    order.number = number;
    order.frame = next_;
    // A picture at which thinning begins may fall to it itself: the passes have to hear of it.
    order.keep = thinning_.wants(number);
    const FrameThinning::Decision decision = thinning_.take(number);
    if (decision.thin)
    {
        for (std::size_t i = 0; i < pictureTimes_.size(); i += 2)
        {
            pictureTimes_[i / 2] = pictureTimes_[i];
        }
        pictureTimes_.resize((pictureTimes_.size() + 1) / 2);
    }
    if (decision.keep)
    {
        pictureTimes_.push_back(snapshots_[newest_].time);
        kept_ = falls_ && !over_ ? kept_ : taken_;
    }
    drawing_.push([this, order] { draw(order); });
}

void FrameRecorder::draw(const Order& order)
{
    const Snapshot& snapshot = *order.snapshot;
    if (order.isNew)
    {
        if (path_)
        {
            renderer_->setCamera(path_->at(order.seconds, settings_.camera));
        }
        else
        {
            renderer_->turn(order.angle);
        }
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
                 {"Time", fmt::format("{:.9g} s", snapshot.time)},
                 {"State", fmt::format("{} running, {} frozen, {} discarded, {} polygons discarded",
                                       snapshot.running, snapshot.frozen, snapshot.discarded,
                                       snapshot.discardedPolygons)}});
    sideOutputs_.put(order.number, order.keep, *renderer_, snapshot, *image_);
}

void FrameRecorder::finish(const Simulation& simulation)
{
    taken_ = over_ || !falls_ ? taken_ : ~0ULL;
    over_ = true;
    if (selection_.isLastOnly())
    {
        next_ = 0; // a turn begins with it
    }
    for (const std::size_t end = next_ + held_; next_ < end && !stops();)
    {
        takeNext(simulation, selection_.hasLast() || selection_.has(next_));
    }
    if (selection_.hasLast() && kept_ != simulation.revision())
    {
        keepLast(simulation);
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

void FrameRecorder::keepLast(const Simulation& simulation)
{
    // Thinning may double the stride under our hands; the last state has to survive it.
    do
    {
        const std::size_t stride = thinning_.stride();
        selected_ = (selected_ + stride - 1) / stride * stride;
        take(simulation, selected_);
    } while (!thinning_.wants(selected_));
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
