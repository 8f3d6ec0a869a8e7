// SPDX-License-Identifier: MIT
// Pictures of a run forget spheres that are discarded and hidden: the same pictures as of all.
#include "base/sanitized.hpp"
#include "support/heap_in_use.hpp"
#include "support/pictures.hpp"

#include <frostfill/renderer.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using testing_support::addSphere;
using testing_support::boxMesh;
using testing_support::heapInUse;
using testing_support::smallPicture;

constexpr std::uint32_t kAlong = 36; ///< spheres side by side

/// A cube of 2 that fills layer by layer. What is three layers below the highest is discarded.
class FillingCube
{
public:
    /// So many spheres side by side.
    explicit FillingCube(std::uint32_t along) : along_(along) { snapshot_.source = 1; }

    [[nodiscard]] std::uint32_t inLayer() const { return along_ * along_; }

    [[nodiscard]] Snapshot& snapshot() { return snapshot_; }
    void begin()
    {
        snapshot_.changed.clear();
        snapshot_.changedSince = snapshot_.revision++;
    }
    void setState(std::uint32_t id, SphereState state)
    {
        snapshot_.states[id] = state;
        snapshot_.changed.push_back(id);
    }
    void addLayer()
    {
        begin();
        const auto first = static_cast<std::uint32_t>(snapshot_.states.size());
        // A snapshot that is filled in turn with others tells of changes once more.
        for (std::uint32_t below = 6; below >= 3; --below)
        {
            for (std::uint32_t id = 0; first >= below * inLayer() && id < inLayer(); ++id)
            {
                setState(first + id - below * inLayer(), SphereState::discarded);
            }
        }
        const double step = 2.0 / along_;
        for (std::uint32_t k = 0; k < inLayer(); ++k)
        {
            const std::uint32_t layer = first / inLayer();
            const std::uint32_t row = k / along_;
            const Eigen::Vector3d place(k % along_, layer, row);
            addSphere(snapshot_, step * (place.array() + 0.5) - 1, 0.55 * step,
                      SphereState::frozen);
            snapshot_.changed.push_back(first + k);
        }
    }

private:
    std::uint32_t along_;
    Snapshot snapshot_;
};

class ForgottenSpheres : public ::testing::TestWithParam<Look>
{
protected:
    void expectEqual(const char* when)
    {
        EXPECT_EQ(
            compareImages(kept_.draw(filling_.snapshot()), all_.draw(filling_.snapshot())).largest,
            0)
            << when << ", with " << filling_.snapshot().states.size() << " spheres";
    }
    void fill(std::size_t layers)
    {
        for (std::size_t layer = 0; layer < layers; ++layer)
        {
            filling_.addLayer();
            expectEqual("while it fills");
        }
    }
    static RenderSettings drawingAll()
    {
        RenderSettings settings = smallPicture(GetParam());
        settings.staticLayer = false;
        return settings;
    }

    TriangleMesh mesh_ = boxMesh({2, 2, 2});
    Renderer kept_{mesh_, smallPicture(GetParam())};
    Renderer all_{mesh_, drawingAll()};
    FillingCube filling_{kAlong};
};

TEST_P(ForgottenSpheres, AreMissingInNoPicture)
{
    fill(20);
    filling_.begin();
    for (std::uint32_t id = 0; id < filling_.snapshot().states.size(); id += 7)
    {
        filling_.setState(id, SphereState::frozen); // as when a guard has tripped
    }
    expectEqual("when some come back");
    fill(4);
}

TEST_P(ForgottenSpheres, AreThereWhenTheCameraMoves)
{
    fill(18);
    RenderSettings settings = smallPicture(GetParam());
    for (const double azimuth : {200.0, 201.0})
    {
        settings.camera.azimuth = azimuth;
        settings.camera.elevation = -40;
        kept_.setCamera(settings.camera);
        all_.setCamera(settings.camera);
        expectEqual("from below");
    }
    filling_.addLayer();
    expectEqual("with a layer more");
    kept_.turn(90);
    all_.turn(90);
    filling_.addLayer(); // at once
    expectEqual("from the side, and a layer more");
}

TEST_P(ForgottenSpheres, AreSeenWhenTheyRunAgain)
{
    fill(18);
    filling_.begin();
    for (std::uint32_t id = 0; id < 1000; ++id)
    {
        const std::uint32_t from = filling_.inLayer() + 3 * id; // from deep in the pile
        filling_.setState(from, SphereState::running);
        filling_.snapshot().centres[from].y() += 1.5F;
    }
    expectEqual("when some have risen");
    fill(2);
}

INSTANTIATE_TEST_SUITE_P(Looks, ForgottenSpheres, ::testing::Values(Look::clean, Look::studio),
                         [](const auto& look)
                         { return look.param == Look::clean ? "Clean" : "Studio"; });

// What pictures keep of each, beside the snapshot: its place among all, and where its row is.
TEST(ForgottenSpheresOfManyLayers, TakeFewBytesInTheRenderer)
{
#ifdef FROSTFILL_SANITIZED
    GTEST_SKIP() << "the heap is the sanitizer's";
#endif
    const TriangleMesh mesh = boxMesh({2, 2, 2});
    Renderer renderer(mesh, smallPicture(Look::clean));
    constexpr std::uint32_t kManyAlong = 72;
    FillingCube filling(kManyAlong);
    std::size_t bytes = 0;
    std::size_t atFirst = 0;
    constexpr std::uint32_t kFirst = 12; // until the tiles are there
    for (std::uint32_t layer = 0; layer < kManyAlong; ++layer)
    {
        filling.addLayer();
        const std::size_t before = heapInUse();
        (void)renderer.draw(filling.snapshot());
        bytes += heapInUse() - before;
        atFirst = layer < kFirst ? bytes : atFirst;
    }
    const double each = (static_cast<double>(bytes) - static_cast<double>(atFirst)) /
                        static_cast<double>((kManyAlong - kFirst) * filling.inLayer());
    RecordProperty("hundredths_of_bytes", static_cast<int>(100 * each));
    EXPECT_LT(each, 40) << "more than 52 where all are kept";
}

} // namespace
} // namespace frostfill
