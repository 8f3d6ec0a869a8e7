// SPDX-License-Identifier: MIT
#pragma once

#include "export/glb_file.hpp"

#include <cstddef>
#include <vector>

namespace frostfill
{

/// Gathers how the nodes of the spheres move and when they appear. A sphere has keys from the frame
/// in which it appears to the one in which it comes to rest, and none after that.
class GlbAnimation
{
public:
    void add(const ExportedFrame& frame);
    [[nodiscard]] std::size_t frames() const { return times_.size(); }

    /// Node i is that of sphere i, and `object` is that of the object. Adds nothing for a single
    /// frame. Once.
    void addTo(GlbFile& file, const std::vector<double>& radii, std::size_t object) const;

private:
    struct Track
    {
        std::size_t first = 0; ///< frame in which the sphere appears
        std::size_t last = 0;  ///< in which it has moved for the last time
        /// [3 (last - first + 1)] relative to the origin of pictures
        std::vector<float> places;
    };
    void addTrack(GlbFile& file, GlbFile::Json& animation, std::size_t times, std::size_t node,
                  double radius) const;
    void addPoses(GlbFile& file, GlbFile::Json& animation, std::size_t times,
                  std::size_t object) const;
    /// Times of the frames first to last, from the view of all times.
    [[nodiscard]] std::size_t timesOf(GlbFile& file, std::size_t times, std::size_t first,
                                      std::size_t last) const;

    std::vector<float> times_; ///< [s] since the first frame
    double start_ = 0;         ///< [s] time of the first frame
    std::vector<Track> tracks_;
    std::vector<float> offsets_;   ///< [3 #F] of the object
    std::vector<float> rotations_; ///< [4 #F] x, y, z, w
    bool turns_ = false;           ///< the object moves
};

} // namespace frostfill
