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
    if (scene.style.colourBy == "auto" && framesToDraw(scene).isLastOnly() &&
        !isBuiltInMesh(scene.object.mesh))
    {
        Palette& palette = settings.style.palette;
        palette.running = palette.discarded = palette.frozen;
        std::copy_n(palette.activePolygon.begin(), 3, palette.discardedPolygon.begin());
    }
    settings.style.colourBy = scene.style.colourBy == "auto" ? "state" : scene.style.colourBy;
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

/// Of a picture's shorter edge [pixel]: smaller ones may show nothing of the spheres that they
/// have.
constexpr int kFewPixels = 8;

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

PngText textOfFrame(const PicturePlan::Picture& picture, const Snapshot& snapshot)
{
    PngText text = {
        {"Frame", fmt::format("{}", picture.frame)},
        {"Time", fmt::format("{:.9g} s", snapshot.time)},
        {"State",
         fmt::format("{} running, {} frozen, {} discarded, {} polygons discarded", snapshot.running,
                     snapshot.frozen, snapshot.discarded, snapshot.discardedPolygons)}};
    if (picture.clock != picture.frame)
    {
        text.emplace_back("Frame of the turn", fmt::format("{}", picture.clock));
    }
    return text;
}

bool showsSpheres(const Snapshot& state)
{
    return state.running + state.frozen + state.discarded > 0; // those that wait are not drawn
}

} // namespace

FramePainter::FramePainter(const PaintRequest& request)
    : request_(request), plan_(request.scene, request.turn, !request.video.empty()),
      settings_(renderSettings(request.scene, request.range, request.poses)),
      writer_(request.directory / "frames", textOfRun(request)),
      sideOutputs_(request.scene, request.directory, request.video)
{
    if (request_.path)
    {
        settings_.camera = request_.path->at(0, settings_.camera);
        settings_.camera.turntable = 1; // the object fits, equally large, at all angles
    }
    drawing_.push([this] { open(); });
    drawing_.finish();
}

FramePainter::~FramePainter()
{
    try
    {
        drawing_.push([this] { renderer_.reset(); });
        drawing_.finish();
    }
    catch (...)
    {
        // finish() reports errors. A destructor must not throw.
    }
}

void FramePainter::push(const PicturePlan::Picture& picture, const Snapshot& state)
{
    drawing_.push([this, picture, &state] { draw(picture, state); });
}

void FramePainter::finish(std::size_t number, const Snapshot* last,
                          const std::function<void()>& taken)
{
    plan_.finish(number, last != nullptr ? last->revision : 0, stopRequested_,
                 [&](const PicturePlan::Picture& picture)
                 {
                     push(picture, *last);
                     if (taken)
                     {
                         taken();
                     }
                 });
    drawing_.push([this] { close(); });
    drawing_.finish();
}

void FramePainter::open()
{
    const Column* shown = findColumn(settings_.style.colourBy);
    if (shown != nullptr && shown->measured)
    {
        measured_.emplace(request_.mesh, std::vector{shown->name}, request_.scene.threads);
    }
    renderer_.emplace(request_.mesh, settings_);
    drawn_.renderer = renderer_->description();
}

/// How far the camera has gone: on its path [s], or round the object [degree].
double FramePainter::cameraAt(std::size_t clock) const
{
    const double fps = request_.scene.frames.fps;
    if (request_.path)
    {
        return std::min(static_cast<double>(clock) / fps, request_.path->duration());
    }
    const auto& turn = settings_.camera.turntable;
    return turn ? 360 * std::fmod(static_cast<double>(clock) / (fps * *turn), 1.0) : 0;
}

/// Whether a picture is not drawn, and for which reason.
bool FramePainter::leavesOut(const PicturePlan::Picture& picture, const PngText& text)
{
    if (!picture.index)
    {
        return false;
    }
    const auto [first, end] = request_.pictures;
    const bool ours = *picture.index >= first && *picture.index < end;
    drawn_.others += ours ? 0 : 1;
    const bool isThere =
        ours && request_.skips() && writer_.has(picture.frame, settings_.size, text);
    drawn_.skipped += isThere ? 1 : 0;
    if (ours && !isThere && request_.onlyLook)
    {
        drawn_.missing.push_back(picture.frame);
    }
    return !ours || isThere || request_.onlyLook;
}

/// The state with what is measured of it. All of it is drawn again: a value may change where
/// nothing has moved.
const Snapshot& FramePainter::measured(const Snapshot& state)
{
    measuredState_ = state;
    measuredState_.source = 0;
    measured_->fill(measuredState_);
    return measuredState_;
}

void FramePainter::draw(const PicturePlan::Picture& picture, const Snapshot& state)
{
    const std::pair shown(state.revision, cameraAt(picture.clock));
    const bool isNew = shown_ != shown;
    shown_ = shown;
    state_ = measured_ ? state_ : &state;
    if (isNew)
    {
        drawn_.sets.resize(std::max(drawn_.sets.size(), std::size_t{state.set} + 1));
        drawn_.sets[state.set].renderMs.push_back(0); // unless it is drawn
        drawn_.sets[state.set].readbackMs.push_back(0);
    }
    if (picture.index)
    {
        drawn_.numbers.push_back(picture.frame);
    }
    const PngText text = textOfFrame(picture, state);
    if (leavesOut(picture, text))
    {
        isDrawn_ = isDrawn_ && !isNew;
        return;
    }
    const bool draws = isNew || !isDrawn_;
    if (draws)
    {
        state_ = measured_ ? &measured(state) : &state;
        render(*state_, isNew);
    }
    changedRows_.resize(static_cast<std::size_t>(image_->height), 1);
    const auto& rows = renderer_->changedRows();
    for (std::size_t y = 0; draws && y < rows.size(); ++y)
    {
        changedRows_[y] |= rows[y];
    }
    if (picture.index)
    {
        writer_.put(picture.frame, *image_, changedRows_, state.set, text);
        changedRows_.assign(changedRows_.size(), 0);
    }
    sideOutputs_.put(picture.frame, picture.index.has_value(), *renderer_, *state_, *image_);
}

void FramePainter::render(const Snapshot& state, bool isNew)
{
    if (request_.path)
    {
        renderer_->setCamera(request_.path->at(shown_->second, settings_.camera));
    }
    else
    {
        renderer_->turn(shown_->second);
    }
    const StageTimes before = renderer_->times();
    image_ = &renderer_->draw(state);
    isDrawn_ = true;
    const StageTimes& after = renderer_->times();
    const auto spent = [&](Stage stage) { return 1000 * (after[stage] - before[stage]); };
    if (isNew)
    {
        drawn_.sets[state.set].renderMs.back() = spent(Stage::rendering);
        drawn_.sets[state.set].readbackMs.back() = spent(Stage::readback);
    }
}

void FramePainter::close()
{
    drawn_.videoFailure = sideOutputs_.finish();
    drawn_.times = renderer_->times();
    checkForBlank();
    renderer_.reset();
    writer_.finish();
    drawn_.times += writer_.times();
    const auto& encoding = writer_.milliseconds();
    drawn_.sets.resize(std::max(drawn_.sets.size(), encoding.size()));
    for (std::size_t set = 0; set < encoding.size(); ++set)
    {
        drawn_.sets[set].encodeMs = encoding[set];
    }
}

void FramePainter::checkForBlank()
{
    if (!isDrawn_ || state_ == nullptr || !showsSpheres(*state_) ||
        std::min(settings_.size.width, settings_.size.height) < kFewPixels)
    {
        return;
    }
    try
    {
        PassPictures seen;
        seen.withIdentity = false;
        renderer_->renderPasses(*state_, seen);
        drawn_.blank = std::all_of(seen.depth.pixels.begin(), seen.depth.pixels.end(),
                                   [](std::uint8_t byte) { return byte == 255; });
    }
    catch (const Error&)
    {
        // The pictures are there: without memory for another pass the run is no worse.
    }
}

} // namespace frostfill
