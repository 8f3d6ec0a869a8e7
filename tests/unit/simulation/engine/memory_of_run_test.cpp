// SPDX-License-Identifier: MIT
#include "base/resources.hpp"
#include "support/heap_in_use.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using testing_support::heapInUse;

// Beside the object, which takes what its surface takes. Of runs that are large enough for the
// front to be thin.
TEST(MemoryOfARun, IsLessThanEightyBytesForASphere)
{
#ifdef FROSTFILL_SANITIZED
    GTEST_SKIP() << "the heap is the sanitizer's";
#endif
    Scene scene = presetScene(Preset::fast, "cube");
    scene.motion.mode = Motion::descend;
    scene.spheres.count = 150000;
    scene.threads = 1;
    const Simulation object(scene, builtInMesh("cube"));
    const std::size_t before = heapInUse();
    Simulation run(scene, object);
    std::size_t most = heapInUse();
    while (run.step())
    {
        most = std::max(most, heapInUse());
    }
    const auto spheres = static_cast<double>(run.sphereCount());
    const double each = static_cast<double>(most - before) / spheres;
    RecordProperty("bytes", static_cast<int>(each));
    EXPECT_LT(each, 80) << "the table in docs/measuring.md says what for";
    EXPECT_GT(each, 48) << "a place, a radius, an id, a group and two rows";
}

} // namespace
} // namespace frostfill
