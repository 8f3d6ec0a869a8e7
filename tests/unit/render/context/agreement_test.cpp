// SPDX-License-Identifier: MIT
// Tiles draw the pictures of OSMesa, in whatever style, from wherever, and cut open or whole.
#include "unit/render/context/agreement.hpp"

#include "support/drawn_with.hpp"
#include "support/pictures.hpp"

#include <frostfill/renderer.hpp>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace frostfill
{
namespace
{

using namespace testing_support;
using test::Apart;
using test::Subject;
using test::subjectOf;
using test::worstRegion;

std::vector<Subject> subjects()
{
    return {subjectOf("torus", torusMesh(1, 0.4, 24, 8), 0.4),
            subjectOf("fine torus", torusMesh(1, 0.4, 300, 100), 0.2),
            subjectOf("box", boxMesh({1, 0.8, 0.6}), 0.3)};
}

std::vector<Camera> cameras()
{
    std::vector<Camera> all(4);
    all[1].azimuth = -70;
    all[1].elevation = 55;
    all[1].orthographic = true;
    all[2].azimuth = 120;
    all[2].elevation = -20;
    all[2].zoom = 2;
    all[3].azimuth = 10;
    all[3].fieldOfView = 80;
    return all;
}

class Agreement : public testing::Test
{
protected:
    Agreement() { settings.size = {480, 270}; }
    void SetUp() override
    {
        if (!test::openGl())
        {
            GTEST_SKIP() << test::kNoOpenGl;
        }
    }

    void choose(Look look)
    {
        settings.style.look = look;
        settings.style.palette = paletteOf(look);
    }

    /// For all subjects and cameras, with one sample or four.
    void expectAgreement(const std::string& what, const Apart& bounds)
    {
        double rms = 0;
        double region = 0;
        std::string where;
        std::vector<Subject> all = subjects();
        for (Subject& subject : all)
        {
            for (float& radius : subject.snapshot.radii)
            {
                radius *= larger;
            }
            for (const Camera& camera : cameras())
            {
                settings.camera = camera;
                settings.samples = 5 - settings.samples;
                std::vector<Image> pictures;
                for (const Backend backend : {*test::openGl(), Backend::automatic})
                {
                    settings.backend = backend;
                    Renderer renderer(subject.mesh, settings);
                    EXPECT_EQ(renderer.description().substr(0, 7) == "builtin",
                              backend == Backend::automatic);
                    pictures.push_back(renderer.draw(subject.snapshot));
                }
                const double own = compareImages(pictures[0], pictures[1]).rootMeanSquare;
                const double worst = worstRegion(pictures[0], pictures[1]);
                if (own > rms)
                {
                    rms = own;
                    where = fmt::format("{}, azimuth {}, {} samples", subject.name,
                                        camera.azimuth.value_or(0), settings.samples);
                }
                region = std::max(region, worst);
            }
        }
        EXPECT_LT(rms, bounds.rms) << what << ", " << where;
        EXPECT_LT(region, bounds.region) << what << ", " << where;
        RecordProperty("rms", fmt::format("{:.2f} {}", rms, where));
        fmt::print("{}: rms {:.2f} ({}), region {:.1f}\n", what, rms, where, region);
    }

    RenderSettings settings;
    float larger = 1; ///< spheres, by this factor
};

const Cutaway kPlane{Cutaway::Kind::plane, {0.2, 0.3, 1}, 0.05, 0, 90};
const Cutaway kWedge{Cutaway::Kind::wedge, {0, 0, 1}, 0, -30, 80};

TEST_F(Agreement, IsThereForEveryStyle)
{
    for (const Look look : {Look::clean, Look::paper, Look::dark, Look::studio})
    {
        choose(look);
        expectAgreement(fmt::format("look {}", static_cast<int>(look)), {});
    }
}

TEST_F(Agreement, IsThereForCutaways)
{
    for (const Look look : {Look::clean, Look::paper, Look::dark, Look::studio})
    {
        choose(look);
        for (const Cutaway& cutaway : {kPlane, kWedge})
        {
            settings.style.cutaway = cutaway;
            expectAgreement(fmt::format("look {}, cut {}", static_cast<int>(look),
                                        static_cast<int>(cutaway.kind)),
                            {});
        }
    }
}

// Spheres keep light from each other where they are close.
TEST_F(Agreement, IsThereForAmbientOcclusion)
{
    settings.style.ambientOcclusion = true;
    larger = 1.7F;
    for (const Look look : {Look::clean, Look::paper, Look::studio})
    {
        choose(look);
        expectAgreement(fmt::format("occlusion, look {}", static_cast<int>(look)), {});
    }
}

} // namespace
} // namespace frostfill
