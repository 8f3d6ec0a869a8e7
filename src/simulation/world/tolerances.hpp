// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace frostfill
{

// The numbers of the world: grids, memory, how the object moves. [r] is the run's unit of length.

/// Edge of a cell of the triangles' grid. [r] The lists of triangles stay short, and 27 cells hold
/// every sphere near. Larger: longer lists. Smaller: more memory.
inline constexpr double kTriangleCell = 1;
/// Each cell lists the triangles up to so far away: the largest radius, and as much as a sphere
/// moves while a list is in use. [r] Smaller than 1: spheres miss walls. Larger: longer lists.
inline constexpr double kTriangleReach = 1.5;
/// Edge of a cell of the spheres' grid. [r] Two radii, so that 27 cells hold all that a sphere may
/// touch. Smaller: a search misses spheres. Larger: longer lists.
inline constexpr double kSphereCell = 2;
/// Spheres in a cell from which on those of at most half the largest radius of their grid get a
/// grid of half the cell. [1] Larger: more spheres to look at. Smaller: more cells, most of them
/// empty.
inline constexpr double kCrowdedCell = 4;
/// What the grids have beyond the object's box. [r] A centre in contact with the outside of a wall
/// must have a cell.
inline constexpr double kGridMargin = 2;
/// Where cubes are too many for memory or their numbers, they grow by this factor until they fit.
/// Larger: cubes larger than needed. Smaller: more tries.
inline constexpr double kCubeGrowth = 1.02;
/// An object with more cells inside and near its walls is refused: its grids take some ten bytes a
/// cell, and minutes.
inline constexpr double kMaxCells = 1e9;
/// Memory of a set of the cubes that may hold a centre above which they are made larger; two are
/// needed at once. 100 million spheres take 300 MB. Larger: memory. Smaller: huge runs discard
/// nothing. [bytes]
inline constexpr std::size_t kMostMapBytes = std::size_t{384} << 20;
/// So is one whose box is longer than this [r]: the numbers of its cells would not fit.
inline constexpr double kMaxLength = 2e7;
/// Memory is set aside for so many times the spheres that fit by the estimate. Smaller: arrays of a
/// large run are copied. Larger: unused memory.
inline constexpr double kRoomForSpheres = 1.1;
/// A centre that is nearer to a wall lies on it, but for rounding. [r] Larger: places near a wall
/// are refused. Smaller: spheres are released on the wall, which has no side there.
inline constexpr double kOnTheWall = 1e-9;
/// Share of the object's mean cross-section that a set covers when its size is not given. Larger:
/// faster fillings with more collisions on the way. Smaller: more sets.
inline constexpr double kFootprint = 0.1;
/// Video in which a set falls and comes to rest [s]: the whole run takes the scene's duration, so
/// this decides how many sets there are. Larger: falls are slower in the video, and more spheres
/// fall at once, which takes longer to simulate. Smaller: falls are too fast to be seen.
inline constexpr double kSecondsPerSet = 0.8;
/// Spheres in a group at least when its size is not given: the paper's number.
inline constexpr std::size_t kSmallestGroup = 10;

// The object's motion.

/// Falls through the object's height that a motion lasts by default. Smaller: spheres are thrown.
/// Larger: longer videos.
inline constexpr double kFalls = 8;
/// Share of gravity that shaking reaches by default. From 1 on spheres fly.
inline constexpr double kShareOfGravity = 0.5;
/// Share of the time in which shaking sets in, and ends. Smaller: a jolt at both ends.
inline constexpr double kRamp = 0.1;
/// Step of finite differences, as a share of the shortest time in which something changes. Larger:
/// their error grows with its square. Smaller: rounding grows with its inverse square.
inline constexpr double kDifference = 1e-3;
/// Pull below which nothing is carried nor let go. [g] Larger: spheres hang in a shaken object.
/// Smaller: the pull's direction is that of its rounding, and piles wake for nothing.
inline constexpr double kWeightless = 0.05;

} // namespace frostfill
