// SPDX-License-Identifier: MIT
#include "run/frame_painter.hpp"

#include "run/frame_timing.hpp"

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

/// In every picture of a run.
PngText textOfRun(const PaintRequest& request)
{
    PngText text = {{"Software", "Frostfill"}, {"Title", request.scene.name}, {"Run", request.run}};
    if (request.path)
    {
        text.emplace_back("Camera", request.path->text());
    }
    return text;
}

PngText textOfFrame(std::size_t frame, const Snapshot& snapshot)
{
    return {{"Frame", fmt::format("{}", frame)},
            {"Time", fmt::format("{:.9g} s", snapshot.time)},
            {"State", fmt::format("{} running, {} frozen, {} discarded, {} polygons discarded",
                                  snapshot.running, snapshot.frozen, snapshot.discarded,
                                  snapshot.discardedPolygons)}};
}

} // namespace

FramePainter::FramePainter(PaintRequest request)
    : request_(std::move(request)), scene_(request_.scene),
      settings_(renderSettings(scene_, request_.range, request_.poses)),
      selection_(framesToDraw(scene_)), thinning_(scene_.frames.limit),
      held_(heldFrames(scene_, request_.path ? request_.path->duration() : 0)),
      writer_(request_.directory / "frames", scene_.frames.limit, textOfRun(request_)),
      sideOutputs_(scene_, request_.directory, request_.video)
{
    request_.skipExisting = request_.skipExisting && request_.video.empty() &&
                            (request_.onlyLook || !scene_.frames.passes.any());
    if (request_.path)
    {
        settings_.camera = request_.path->at(0, settings_.camera);
        settings_.camera.turntable = 1; // the object fits, equally large, at all angles
    }
    // A context belongs to the thread that draws with it.
    drawing_.push([this] { renderer_ = std::make_unique<Renderer>(request_.mesh, settings_); });
    drawing_.finish();
    description_ = renderer_->description();
    objectRegion_ = renderer_->objectRegion();
}

FramePainter::~FramePainter()
{
    try
    {
        closeRenderer();
    }
    catch (...)
    {
        // finish() reports errors. A destructor must not throw.
    }
}

void FramePainter::closeRenderer()
{
    drawing_.push([this] { renderer_.reset(); });
    drawing_.finish();
}

void FramePainter::keepEvery(std::size_t stride)
{
    thinning_.keepEvery(stride);
    drawing_.push(
        [this, stride]
        {
            writer_.keepEvery(stride);
            sideOutputs_.keepEvery(stride);
        });
}

bool FramePainter::wantsNumber(std::size_t number) const
{
    return thinning_.wants(number) || sideOutputs_.wantEveryFrame();
}

bool FramePainter::wants(std::size_t frame) const
{
    return selection_.has(frame) && wantsNumber(selected_);
}

void FramePainter::pass(std::size_t frame)
{
    selected_ += selection_.has(frame) ? 1 : 0;
}

void FramePainter::take(std::size_t frame, const State& state)
{
    takeNumber(frame, selected_, state);
    ++selected_;
}

/// How far the camera has gone round. [degree]
double FramePainter::angleAt(std::size_t frame) const
{
    const auto& turn = settings_.camera.turntable;
    return turn && !request_.path
               ? 360 * std::fmod(static_cast<double>(frame) / (scene_.frames.fps * *turn), 1.0)
               : 0;
}

void FramePainter::takeNumber(std::size_t frame, std::size_t number, const State& state)
{
    Order order;
    order.angle = angleAt(frame);
    order.seconds = request_.path ? std::min(static_cast<double>(frame) / scene_.frames.fps,
                                             request_.path->duration())
                                  : 0;
    order.isNew =
        shown_ != state.revision || shownAngle_ != order.angle || shownSeconds_ != order.seconds;
    shown_ = state.revision;
    shownAngle_ = order.angle;
    shownSeconds_ = order.seconds;
    order.snapshot = state.snapshot;
    last_ = state.snapshot;
    order.number = number;
    order.frame = frame;
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
        request_.skipExisting = false; // from now on pictures change their names
    }
    if (decision.keep)
    {
        pictureTimes_.push_back(state.snapshot->time);
        kept_ = state.revision;
    }
    if (mayLeaveOut() && decision.keep)
    {
        order.index = thinning_.count() - 1;
    }
    drawing_.push([this, order] { draw(order); });
}

/// Whether a picture is not drawn, and for which reason.
bool FramePainter::leavesOut(const Order& order, const PngText& text)
{
    if (!order.index)
    {
        return false;
    }
    const auto [first, end] = request_.pictures;
    const bool ours = *order.index >= first && *order.index < end;
    others_ += ours ? 0 : 1;
    const bool isThere =
        ours && request_.skipExisting && writer_.has(*order.index, settings_.size, text);
    skipped_ += isThere ? 1 : 0;
    if (ours && !isThere && request_.onlyLook)
    {
        missing_.push_back(*order.index);
    }
    return !ours || isThere || request_.onlyLook;
}

void FramePainter::draw(const Order& order)
{
    const Snapshot& snapshot = *order.snapshot;
    const PngText text = textOfFrame(order.frame, snapshot);
    if (leavesOut(order, text))
    {
        writer_.skip(order.number);
        sideOutputs_.skip(order.number);
        isDrawn_ = isDrawn_ && !order.isNew;
        if (order.isNew)
        {
            count(snapshot, 0, 0);
        }
        return;
    }
    const bool draws = order.isNew || !isDrawn_;
    if (draws)
    {
        turnTo(order);
        const StageTimes before = renderer_->times();
        image_ = &renderer_->draw(snapshot);
        isDrawn_ = true;
        const StageTimes& after = renderer_->times();
        const auto spent = [&](Stage stage) { return 1000 * (after[stage] - before[stage]); };
        if (order.isNew)
        {
            count(snapshot, spent(Stage::rendering), spent(Stage::readback));
        }
        blank_ =
            blank_ || (!snapshot.centres.empty() && image_->width * image_->height >= kFewPixels &&
                       allPixelsAlike(*image_));
    }
    noRows_.assign(static_cast<std::size_t>(image_->height), 0);
    writer_.put(order.number, *image_, draws ? renderer_->changedRows() : noRows_, snapshot.set,
                text);
    sideOutputs_.put(order.number, order.keep, *renderer_, snapshot, *image_);
}

void FramePainter::turnTo(const Order& order)
{
    if (request_.path)
    {
        renderer_->setCamera(request_.path->at(order.seconds, settings_.camera));
    }
    else
    {
        renderer_->turn(order.angle);
    }
}

void FramePainter::count(const Snapshot& snapshot, double renderMs, double readbackMs)
{
    if (sets_.size() <= snapshot.set)
    {
        sets_.resize(snapshot.set + 1);
    }
    sets_[snapshot.set].renderMs.push_back(renderMs);
    sets_[snapshot.set].readbackMs.push_back(readbackMs);
}

void FramePainter::finish(std::size_t frame, const State& last)
{
    std::size_t next = selection_.isLastOnly() ? 0 : frame; // a turn begins with it
    const auto stops = [&] { return stopRequested_ && stopRequested_(); };
    for (const std::size_t end = next + held_; next < end && !stops(); ++next)
    {
        if (selection_.hasLast() || selection_.has(next))
        {
            if (wantsNumber(selected_))
            {
                takeNumber(next, selected_, last);
            }
            ++selected_;
        }
    }
    if (selection_.hasLast() && kept_ != last.revision)
    {
        keepLast(next, last);
    }
    drawing_.push(
        [this]
        {
            videoFailure_ = sideOutputs_.finish();
            times_ = renderer_->times();
            renderer_.reset();
            if (last_ != nullptr && !last_->centres.empty())
            {
                lookForSpheres(*last_);
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

void FramePainter::keepLast(std::size_t frame, const State& state)
{
    // Thinning may double the stride under our hands; the last state has to survive it.
    do
    {
        const std::size_t stride = thinning_.stride();
        selected_ = (selected_ + stride - 1) / stride * stride;
        takeNumber(frame, selected_, state);
    } while (!thinning_.wants(selected_));
}

void FramePainter::lookForSpheres(const Snapshot& snapshot)
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
        Renderer(request_.mesh, small).render(snapshot, image);
        blank_ = blank_ || allPixelsAlike(image);
    }
    catch (const Error&)
    {
        // Without memory for another context the run is no worse.
    }
}

} // namespace frostfill
