// SPDX-License-Identifier: MIT
#pragma once

#include "run_file/bytes.hpp"
#include "run_file/column_codec.hpp"

#include <frostfill/run_file.hpp>

#include <array>
#include <vector>

namespace frostfill
{

/// A sphere that moved in the frame before, on the grid of the file.
struct Track
{
    std::uint32_t id = 0;
    std::array<std::int64_t, 3> place{};
    std::array<std::int64_t, 3> step{}; ///< from the frame before that
};

/// In the flags of a frame: its pose follows; it shows the state of the frame before, and nothing
/// follows.
inline constexpr std::uint64_t kHasPose = 1;
inline constexpr std::uint64_t kIsRepeated = 2;

[[nodiscard]] inline bool hasMoved(const Pose& pose)
{
    return !pose.rotation.isIdentity(0) || !pose.offset.isZero(0);
}

/// Goes through the tracks of the frame before along with ascending ids.
class TrackFinder
{
public:
    explicit TrackFinder(const std::vector<Track>& before) : before_(before) {}
    [[nodiscard]] const Track* operator()(std::uint32_t id)
    {
        while (at_ < before_.size() && before_[at_].id < id)
        {
            ++at_;
        }
        return at_ < before_.size() && before_[at_].id == id ? &before_[at_] : nullptr;
    }

private:
    const std::vector<Track>& before_;
    std::size_t at_ = 0;
};

inline constexpr double kGridsInARadius = 10000;

/// The grid to which places of moving spheres are rounded: a power of two, so that a rounded place
/// is a float's exact value, and at least this many in the smallest radius.
[[nodiscard]] double gridOf(double smallestRadius, double stepsInARadius = kGridsInARadius);

/// Where pictures see a sphere at rest.
[[nodiscard]] Eigen::Vector3f placeInPictures(const Eigen::Vector3d& exact,
                                              const Eigen::Vector3d& origin);

/// With so many binary digits less, as files keep speeds.
[[nodiscard]] float roundedSpeed(float speed);

/// Writes what has changed from frame to frame.
class FrameEncoder
{
public:
    explicit FrameEncoder(double grid, const std::vector<ColumnValues>& columns = {})
        : grid_(grid), columns_(columns)
    {
    }
    void encode(const Snapshot& snapshot, const ExactSphere& exact, ByteWriter& out);
    /// The frame before once more.
    void repeat(ByteWriter& out) const;

private:
    void sortChanges(const Snapshot& snapshot, const ExactSphere& exact);
    void sortRenewed(const Snapshot& snapshot, const ExactSphere& exact);
    void encodeRenewed(const Snapshot& snapshot, ByteWriter& out) const;
    void encodeMoving(const Snapshot& snapshot, ByteWriter& out);
    void encodeSettled(const ExactSphere& exact, ByteWriter& out) const;
    void encodePolygons(const Snapshot& snapshot, ByteWriter& out);

    double grid_;
    ColumnEncoder columns_;
    double time_ = 0; ///< of the frame before [s], and so on
    std::uint64_t step_ = 0;
    std::uint32_t set_ = 0;
    std::vector<SphereState> states_;
    std::vector<double> radii_; ///< [mesh unit]
    std::vector<std::uint32_t> groups_;
    std::vector<Eigen::Vector3f> places_; ///< of spheres at rest
    std::vector<PolygonState> polygons_;
    std::vector<Track> moving_;
    std::vector<std::uint32_t> renewed_, running_, waiting_, settled_, discarded_; ///< of this one
};

/// Reads what FrameEncoder wrote, in the same order.
class FrameDecoder
{
public:
    FrameDecoder(double grid, const Eigen::Vector3d& origin, std::size_t polygons,
                 std::uint64_t source, std::vector<FileColumn> columns = {});
    /// Throws DamagedBytes. Snapshot::changed grows until forgetChanges().
    void decode(ByteReader& in);
    /// Brings Snapshot::changed into order, each sphere once. To be called before it is looked at.
    void sortChanges();
    [[nodiscard]] const Snapshot& snapshot() const { return snapshot_; }
    void forgetChanges();
    [[nodiscard]] const std::vector<Eigen::Vector3d>& centres() const { return centres_; }
    [[nodiscard]] const std::vector<double>& radii() const { return radii_; }

private:
    void decodePose(ByteReader& in);
    void decodeRenewed(ByteReader& in);
    void decodeMoving(ByteReader& in);
    void decodeWaiting(ByteReader& in);
    void decodeSettled(ByteReader& in);
    void decodePolygons(ByteReader& in);
    void resize(std::size_t count);
    void setState(std::uint32_t id, SphereState state);
    void awaken();

    double grid_;
    ColumnDecoder columns_;
    std::vector<std::uint32_t> waiting_;
    Snapshot snapshot_;
    std::vector<Eigen::Vector3d> centres_;
    std::vector<double> radii_;
    std::vector<Track> moving_;
};

} // namespace frostfill
