// SPDX-License-Identifier: MIT
#include "render/picture/sphere_occlusion.hpp"

#include "render/framing/numbers.hpp"
#include "support/pictures.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace frostfill
{
namespace
{

using namespace testing_support;

const glm::vec3 kLamp = glm::normalize(glm::vec3(-0.5F, 0.9F, 0.6F));

SphereInstance sphereAt(const glm::vec3& place, float radius)
{
    return {place.x, place.y, place.z, radius, 1, {}};
}

std::vector<SphereInstance> cloud(std::size_t count)
{
    Numbers numbers;
    std::vector<SphereInstance> spheres;
    const auto next = [&] { return static_cast<float>(2 * numbers.next() - 1); };
    for (std::size_t i = 0; i < count; ++i)
    {
        const glm::vec3 place(next(), next(), next());
        spheres.push_back(sphereAt(place, 0.03F + 0.04F * std::abs(next())));
    }
    return spheres;
}

bool same(const SphereLight& a, const SphereLight& b)
{
    return a.occluders == b.occluders && a.open == b.open;
}

TEST(SphereOcclusion, OfALoneSphereHideNothing)
{
    SphereOcclusion sphereOcclusion(kLamp, {});
    const SphereInstance sphere = sphereAt({0, 0, 0}, 0.1F);
    EXPECT_TRUE(same(sphereOcclusion.of(sphere), SphereLight{}));
    sphereOcclusion.add(sphere);
    EXPECT_TRUE(same(sphereOcclusion.of(sphere), SphereLight{})) << "it does not hide itself";
    sphereOcclusion.add(sphereAt({1, 0, 0}, 0.1F));
    EXPECT_TRUE(same(sphereOcclusion.of(sphere), SphereLight{})) << "too far away";
}

TEST(SphereOcclusion, TellWhereANeighbourIsInTheRadiusOfTheSphere)
{
    SphereOcclusion sphereOcclusion(kLamp, {});
    sphereOcclusion.add(sphereAt({0.3F, 0, 0}, 0.2F));
    const SphereLight light = sphereOcclusion.of(sphereAt({0, 0, 0}, 0.1F));
    EXPECT_NEAR(light.occluders[0][0] * shading::kOccluderRange / 127, 3, 0.03);
    EXPECT_EQ(light.occluders[0][1], 0);
    EXPECT_NEAR(light.occluders[0][3] * shading::kOccluderRange / 127, 2, 0.03);
    EXPECT_EQ(light.occluders[1][3], 0) << "the only one";
}

TEST(SphereOcclusion, DoNotDependOnTheOrderInWhichTheyCame)
{
    std::vector<SphereInstance> spheres = cloud(1500);
    SphereOcclusion forwards(kLamp, {});
    forwards.start(spheres);
    std::reverse(spheres.begin(), spheres.end());
    SphereOcclusion backwards(kLamp, {});
    backwards.start(std::span(spheres).first(700));
    for (const SphereInstance& sphere : std::span(spheres).subspan(700))
    {
        backwards.add(sphere);
    }
    for (const SphereInstance& sphere : spheres)
    {
        ASSERT_TRUE(same(forwards.of(sphere), backwards.of(sphere)));
    }
}

TEST(SphereOcclusion, ChangeOnlyTheLightOfThoseThatAnArrivalReaches)
{
    const std::vector<SphereInstance> spheres = cloud(1200);
    SphereOcclusion sphereOcclusion(kLamp, {});
    sphereOcclusion.start(std::span(spheres).first(1000));
    int changed = 0;
    int reached = 0;
    for (std::size_t i = 1000; i < spheres.size(); ++i)
    {
        std::vector<SphereLight> before;
        for (std::size_t k = 0; k < 1000; ++k)
        {
            before.push_back(sphereOcclusion.of(spheres[k]));
        }
        sphereOcclusion.add(spheres[i]);
        for (std::size_t k = 0; k < 1000; ++k)
        {
            const bool differs = !same(before[k], sphereOcclusion.of(spheres[k]));
            const bool reaches = sphereOcclusion.reaches(spheres[i], spheres[k]);
            ASSERT_TRUE(reaches || !differs) << i << " on " << k;
            changed += differs ? 1 : 0;
            reached += reaches ? 1 : 0;
        }
        i += 9;
    }
    EXPECT_GT(changed, 100);
    EXPECT_LT(reached, 3 * changed) << "says that it reaches nearly all";
}

const glm::dvec4 kCut(1, 0, 0, -0.5);

/// The oracle: surroundings that are started with the same spheres and keep nothing.
std::vector<SphereLight> lightOnAll(std::span<const SphereInstance> spheres,
                                    const std::optional<CutPlanes>& cut)
{
    SphereOcclusion fresh(kLamp, cut);
    fresh.start(spheres);
    std::vector<SphereLight> lights;
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        lights.push_back(fresh.ofResting(i));
    }
    return lights;
}

TEST(SphereOcclusion, KeepTheLightOfThoseThatAnArrivalDoesNotChange)
{
    constexpr std::uint32_t kSeen = 900;
    for (const auto& cut : {std::optional<CutPlanes>(), std::optional(CutPlanes{kCut, kCut})})
    {
        const std::vector<SphereInstance> spheres = cloud(1100);
        SphereOcclusion sphereOcclusion(kLamp, cut);
        sphereOcclusion.follow(std::span(spheres).first(1000), 0);
        std::vector<std::uint32_t> all(1000);
        std::iota(all.begin(), all.end(), 0U);
        sphereOcclusion.ask(all);
        std::vector<SphereLight> before;
        for (const std::uint32_t sphere : all)
        {
            before.push_back(*sphereOcclusion.lights().of(sphere));
        }
        std::size_t changed = 0;
        for (std::size_t end = 1010; end <= spheres.size(); end += 10)
        {
            const auto now = std::span(spheres).first(end);
            sphereOcclusion.follow(now, end - 10);
            const std::vector<SphereLight> lights = lightOnAll(now, cut);
            std::vector<std::uint32_t> expected;
            for (std::uint32_t k = 0; k < kSeen; ++k)
            {
                if (lights[k] != before[k])
                {
                    expected.push_back(k);
                }
            }
            const auto told = sphereOcclusion.refresh([](std::uint32_t i) { return i < kSeen; });
            std::vector<std::uint32_t> sorted(told.begin(), told.end());
            std::sort(sorted.begin(), sorted.end());
            ASSERT_EQ(sorted, expected) << end;
            ASSERT_TRUE(sphereOcclusion.refresh([](std::uint32_t) { return true; }).empty());
            for (std::uint32_t k = 0; k < 1000; ++k)
            {
                ASSERT_TRUE(same(sphereOcclusion.ofResting(k), lights[k])) << end << ", " << k;
            }
            before = lights;
            changed += expected.size();
        }
        EXPECT_GT(changed, 100U);
    }
}

TEST(SphereOcclusion, KeepWhatIsKnownWhenTheyAreStartedInAnotherOrderAndWithArrivals)
{
    for (const auto& cut : {std::optional<CutPlanes>(), std::optional(CutPlanes{kCut, kCut})})
    {
        std::vector<SphereInstance> spheres = cloud(600);
        SphereOcclusion sphereOcclusion(kLamp, cut);
        sphereOcclusion.start(std::span(spheres).first(500));
        for (std::size_t i = 0; i < 500; ++i)
        {
            sphereOcclusion.ofResting(i);
        }
        std::reverse(spheres.begin(), spheres.end());
        sphereOcclusion.start(spheres);
        std::vector<SphereLight> lights = lightOnAll(spheres, cut);
        for (std::size_t i = 0; i < spheres.size(); ++i)
        {
            ASSERT_TRUE(same(sphereOcclusion.ofResting(i), lights[i])) << i;
        }
        // One has gone, which nothing but a new beginning takes into account.
        spheres.pop_back();
        sphereOcclusion.start(spheres);
        lights = lightOnAll(spheres, cut);
        for (std::size_t i = 0; i < spheres.size(); ++i)
        {
            ASSERT_TRUE(same(sphereOcclusion.ofResting(i), lights[i])) << i;
        }
    }
}

/// The same with other axes.
glm::vec3 onward(const glm::vec3& v)
{
    return {v.z, v.x, v.y};
}

TEST(SphereOcclusion, AreTheSameAlongAnyAxisOfALongHeap)
{
    std::vector<SphereInstance> along = cloud(1000);
    std::vector<SphereInstance> across;
    for (SphereInstance& sphere : along)
    {
        sphere.x *= 4;
        sphere.z *= 0.5F;
        across.push_back(sphereAt(onward({sphere.x, sphere.y, sphere.z}), sphere.radius));
    }
    SphereOcclusion first(kLamp, {});
    first.start(along);
    SphereOcclusion second(onward(kLamp), {});
    second.start(across);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < along.size(); ++i)
    {
        SphereLight light = first.ofResting(i);
        for (auto& occluder : light.occluders)
        {
            occluder = {occluder[2], occluder[0], occluder[1], occluder[3]};
        }
        differ += same(light, second.ofResting(i)) ? 0 : 1;
    }
    EXPECT_LE(differ, 20U) << "sums are rounded in another order";
}

TEST(SphereOcclusion, ForgetWhatACutTakesAway)
{
    // Everything to the right.
    const glm::dvec4 plane(1, 0, 0, 0);
    SphereOcclusion sphereOcclusion(kLamp, CutPlanes{plane, plane});
    sphereOcclusion.add(sphereAt({0.2F, 0, 0}, 0.1F));
    EXPECT_TRUE(same(sphereOcclusion.of(sphereAt({-0.01F, 0, 0}, 0.1F)), SphereLight{}));
    sphereOcclusion.add(sphereAt({-0.2F, 0, 0}, 0.1F));
    EXPECT_FALSE(same(sphereOcclusion.of(sphereAt({-0.01F, 0, 0}, 0.1F)), SphereLight{}));
}

} // namespace
} // namespace frostfill
