// SPDX-License-Identifier: MIT
#pragma once

#include "run_file/bytes.hpp"
#include "run_file/rounding.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace frostfill
{

[[nodiscard]] inline bool hasMoved(const Pose& pose)
{
    return !pose.rotation.isIdentity(0) || !pose.offset.isZero(0);
}

/// The stream of a carried column, which has its type behind its name.
[[nodiscard]] std::string streamOf(const Column& column);

/// What has changed from frame to frame, in streams; docs/run-file.md describes them. A run file
/// and a page hold the same streams, rounded differently. Encoder and decoder know the same state
/// and go through a frame in the same way: one writes each number, the other reads it.
class FrameCodec
{
public:
    FrameCodec(const Rounding& rounding, const Eigen::Vector3d& origin, std::size_t polygons);
    /// The newest frame, as it was kept.
    [[nodiscard]] const Snapshot& snapshot() const { return snapshot_; }
    [[nodiscard]] const std::vector<Eigen::Vector3d>& centres() const { return centres_; }
    [[nodiscard]] const std::vector<double>& radii() const { return radii_; }

protected:
    /// Makes the snapshot carry a column from here on.
    void carry(const Column& column);

    /// In the flags of a frame: it shows the state of the frame before, and nothing follows.
    static constexpr std::uint64_t kIsRepeated = 2;
    /// States in streams have the numbers of SphereState, and one more: the sphere has a number and
    /// waits for its fall to begin, or is nowhere.
    static constexpr std::uint64_t kRuns = 0;
    static constexpr std::uint64_t kWaits = 3;

    /// What is to be encoded.
    struct Given
    {
        const Snapshot& snapshot;
        const ExactSphere& exact;
    };
    using Place = std::array<std::int64_t, 3>; ///< from the origin of pictures [grid]

    /// A frame that differs from the one before. Decodes if nothing is given.
    template <typename Bytes>
    void goThrough(Named<Bytes>& streams, const Given* given);
    [[nodiscard]] std::uint64_t stateOf(const Given& given, std::uint32_t id) const;
    [[nodiscard]] std::int64_t speedOf(const Given& given, std::uint32_t id) const;
    [[nodiscard]] std::uint64_t state(std::uint32_t id) const;
    [[nodiscard]] static bool rests(std::uint64_t state)
    {
        return state != kRuns && state != kWaits;
    }
    [[nodiscard]] Place placeOf(const Eigen::Vector3d& centre) const;
    [[nodiscard]] Eigen::Vector3d centreOf(const Place& place) const;
    void resize(std::size_t count);

    Rounding rounding_;
    Snapshot snapshot_;
    std::vector<Eigen::Vector3d> centres_;                         ///< [mesh unit]
    std::vector<double> radii_;                                    ///< [mesh unit]
    std::vector<std::uint32_t> renewed_, turned_, turnedPolygons_; ///< of this frame
    std::vector<std::uint32_t> moved_, revalued_;                  ///< likewise

private:
    /// A sphere that runs, and how far it went in the frame before.
    struct Track
    {
        std::uint32_t id = 0;
        Place place{};
        Place step{};
    };
    template <typename Bytes>
    void goThroughFacts(std::uint64_t flags, Named<Bytes>& streams, const Given* given);
    template <typename Bytes>
    void goThroughStates(const std::vector<std::uint32_t>& ids, Bytes& states, const Given* given);
    template <typename Bytes>
    void goThroughPlaces(Named<Bytes>& streams, const Given* given);
    template <typename Bytes>
    void goThroughValues(Named<Bytes>& streams, const Given* given);
    template <typename Bytes>
    void goThroughCarried(Named<Bytes>& streams, const Given* given);
    [[nodiscard]] std::vector<std::uint32_t> changedIn(const ColumnValues& known,
                                                       const Given& given) const;
    void addTracks(const std::vector<std::uint32_t>& ids);
    void setState(std::uint32_t id, std::uint64_t state);

    std::array<std::int64_t, 6> facts_{};
    std::vector<Track> tracks_; ///< by ascending id
    Place renewedPlace_{};      ///< of the last one that was
    std::int64_t renewedRadius_ = 0;
    std::int64_t renewedGroup_ = 0;
};

class FrameEncoder : public FrameCodec
{
public:
    using FrameCodec::FrameCodec;
    /// The next frame. `exact` has each sphere's place and radius before they are rounded.
    void encode(const Snapshot& snapshot, const ExactSphere& exact)
    {
        encode(snapshot, exact, snapshot.polygons);
    }
    /// The same with other polygons than those of the snapshot, which still tells how many of its
    /// own are discarded.
    void encode(const Snapshot& snapshot, const ExactSphere& exact,
                const std::vector<PolygonState>& polygons);
    /// The frame before once more.
    void repeat();

    [[nodiscard]] std::size_t bytes() const; ///< of the streams
    /// What was written since it was last called.
    [[nodiscard]] Streams take() { return std::exchange(streams_, {}); }

private:
    void sortChanges(const Given& given);
    void sortChange(std::uint32_t id, const Given& given);
    void sortPolygons(const std::vector<PolygonState>& polygons);

    Streams streams_;
};

/// A number for whatever decodes: it tells the snapshots of files and tapes from those of
/// simulations, and of each other.
[[nodiscard]] std::uint64_t newSource();

/// Of what was kept exactly; a page is decoded by page/film.js.
class FrameDecoder : public FrameCodec
{
public:
    FrameDecoder(double grid, const Eigen::Vector3d& origin, std::size_t polygons,
                 std::uint64_t source);
    /// Throws DamagedBytes. Snapshot::changed grows until forgetChanges().
    void decode(StreamReaders& in);
    /// Brings Snapshot::changed into order, each sphere once. To be called before it is looked at.
    void sortChanges();
    void forgetChanges();
};

} // namespace frostfill
