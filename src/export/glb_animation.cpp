// SPDX-License-Identifier: MIT
#include "export/glb_animation.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using Json = GlbFile::Json;

/// Adds a channel that moves `path` of a node.
void addChannel(Json& animation, std::size_t node, const char* path, std::size_t times,
                std::size_t values, const char* interpolation)
{
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back(
        {{"input", times}, {"output", values}, {"interpolation", interpolation}});
}

} // namespace

void GlbAnimation::add(const ExportedFrame& frame)
{
    const Snapshot& state = frame.state;
    if (times_.empty())
    {
        start_ = state.time;
    }
    // Keys need ascending times, and frames of a run have them; equal ones would be refused.
    const auto time = static_cast<float>(state.time - start_);
    times_.push_back(times_.empty() ? 0 : std::max(time, std::nextafter(times_.back(), 1e30F)));
    const std::size_t now = times_.size() - 1;
    const std::size_t known = tracks_.size();
    tracks_.resize(state.states.size());
    for (std::size_t i = 0; i < tracks_.size(); ++i)
    {
        Track& track = tracks_[i];
        const Eigen::Vector3f place = (frame.centres[i] - state.origin).cast<float>();
        if (i >= known)
        {
            track.first = now;
        }
        else if (std::equal(place.data(), place.data() + 3, track.places.end() - 3))
        {
            continue;
        }
        else
        {
            // It rested in the frames between, and begins to move in the last of them.
            while (track.last + 1 < now)
            {
                const std::size_t end = track.places.size();
                track.places.resize(end + 3);
                std::copy_n(track.places.begin() + static_cast<std::ptrdiff_t>(end) - 3, 3,
                            track.places.begin() + static_cast<std::ptrdiff_t>(end));
                ++track.last;
            }
        }
        track.places.insert(track.places.end(), place.data(), place.data() + 3);
        track.last = now;
    }
    const auto& pose = state.pose;
    for (int axis = 0; axis < 3; ++axis)
    {
        offsets_.push_back(static_cast<float>(pose.offset[axis]));
    }
    const std::array<float, 4> turn = quaternion(pose.rotation);
    rotations_.insert(rotations_.end(), turn.begin(), turn.end());
    turns_ = turns_ || !std::equal(offsets_.end() - 3, offsets_.end(), offsets_.begin()) ||
             !std::equal(turn.begin(), turn.end(), rotations_.begin());
}

std::size_t GlbAnimation::timesOf(GlbFile& file, std::size_t times, std::size_t first,
                                  std::size_t last) const
{
    return file.addAccessor(times, first * sizeof(float), GlbFile::Kind::float32, last - first + 1,
                            "SCALAR", {times_[first]}, {times_[last]});
}

void GlbAnimation::addTrack(GlbFile& file, Json& animation, std::size_t times, std::size_t node,
                            double radius) const
{
    const Track& track = tracks_[node];
    if (track.last > track.first)
    {
        const std::size_t keys = track.last - track.first + 1;
        const std::size_t places =
            file.addAccessor(file.addView(track.places), 0, GlbFile::Kind::float32, keys, "VEC3");
        addChannel(animation, node, "translation", timesOf(file, times, track.first, track.last),
                   places, "LINEAR");
    }
    if (track.first > 0)
    {
        // Of no size until it appears.
        const auto r = static_cast<float>(radius);
        const std::vector<float> sizes = {0, 0, 0, r, r, r};
        const std::vector<float> when = {0, times_[track.first]};
        const std::size_t input = file.addAccessor(file.addView(when), 0, GlbFile::Kind::float32, 2,
                                                   "SCALAR", {0.0F}, {times_[track.first]});
        const std::size_t output =
            file.addAccessor(file.addView(sizes), 0, GlbFile::Kind::float32, 2, "VEC3");
        addChannel(animation, node, "scale", input, output, "STEP");
    }
}

void GlbAnimation::addPoses(GlbFile& file, Json& animation, std::size_t times,
                            std::size_t object) const
{
    const std::size_t input = timesOf(file, times, 0, times_.size() - 1);
    const std::size_t offsets =
        file.addAccessor(file.addView(offsets_), 0, GlbFile::Kind::float32, times_.size(), "VEC3");
    const std::size_t turns = file.addAccessor(file.addView(rotations_), 0, GlbFile::Kind::float32,
                                               times_.size(), "VEC4");
    addChannel(animation, object, "translation", input, offsets, "LINEAR");
    addChannel(animation, object, "rotation", input, turns, "LINEAR");
}

void GlbAnimation::addTo(GlbFile& file, const std::vector<double>& radii, std::size_t object) const
{
    if (times_.size() < 2)
    {
        return;
    }
    Json animation = {{"name", "run"}, {"samplers", Json::array()}, {"channels", Json::array()}};
    const std::size_t times = file.addView(times_);
    for (std::size_t node = 0; node < tracks_.size(); ++node)
    {
        addTrack(file, animation, times, node, radii[node]);
    }
    if (turns_)
    {
        addPoses(file, animation, times, object);
    }
    if (!animation["channels"].empty())
    {
        file.json()["animations"] = {animation};
    }
}

} // namespace frostfill
