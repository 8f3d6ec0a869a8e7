// SPDX-License-Identifier: MIT
// What a page says beside its frames: what only the page's own script reads.
#include "support/shapes.hpp"
#include "unit/page/paged_run.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <string>

namespace frostfill
{
namespace
{

using nlohmann::json;

/// A head whose every number differs from what is usual.
RunHead someHead()
{
    RunHead head;
    head.scene = test::fewSpheres();
    head.scene.name = "torus";
    head.scene.frames.fps = 50;
    head.scene.camera.azimuth = 70;
    head.scene.camera.elevation = 35;
    head.scene.camera.fieldOfView = 25;
    head.scene.camera.zoom = 1.5;
    head.scene.camera.target = Eigen::Vector3d(0.1, 0.2, -0.3);
    head.scene.style.cutaway.kind = Cutaway::Kind::wedge;
    head.scene.style.cutaway.from = 10;
    head.scene.style.cutaway.to = 100;
    head.scene.spheres.groupsPerSet = 3;
    head.interval = 0.004;
    head.version = "9.8.7";
    head.colours = {12, 1, {0.25, 0.5}};
    return head;
}

class PageFacts : public ::testing::Test
{
protected:
    /// The text of the page of a run with this head.
    std::string pageOf(const RunHead& head, const TriangleMesh& mesh = loadMesh("torus").mesh,
                       bool fullMesh = false)
    {
        const test::TemporaryFolder folder;
        RunFileWriter writer(folder / "run.frost", headText(head), mesh, 1);
        Snapshot snapshot;
        snapshot.origin = boundingBox(mesh).center();
        snapshot.polygons.assign(mesh.triangles.size(), PolygonState::active);
        writer.put(0, snapshot, [](std::uint32_t) { return SphereRecord{}; });
        writer.finish(R"({"outcome": "complete"})");
        test::writeFile(folder / "sets.csv", "set,seconds\n0,2.5\n");
        PageRequest request;
        request.run = folder.path();
        request.fullMesh = fullMesh;
        writePage(request);
        return test::readFile(folder / "view.html");
    }
    json factsOf(const RunHead& head) { return factsIn(pageOf(head)); }
    static json factsIn(const std::string& page)
    {
        const std::string begin = R"(<script id="facts" type="application/json">)";
        const std::size_t at = page.find(begin) + begin.size();
        return json::parse(page.substr(at, page.find("</script>", at) - at));
    }
};

TEST_F(PageFacts, AreThoseOfTheRun)
{
    const RunHead head = someHead();
    const json facts = factsOf(head);
    EXPECT_EQ(facts.at("version"), "9.8.7");
    EXPECT_EQ(facts.at("name"), "torus");
    EXPECT_EQ(facts.at("groups_per_set"), 3);
    EXPECT_DOUBLE_EQ(facts.at("rate").get<double>(), 0.004 * 50);
    EXPECT_EQ(facts.at("sets"), "set,seconds\n0,2.5\n");
    EXPECT_EQ(facts.at("summary").at("outcome"), "complete");
    EXPECT_EQ(facts.at("scene").at("frames").at("fps"), 50);
    const json& camera = facts.at("camera");
    EXPECT_EQ(camera.at("azimuth"), 70);
    EXPECT_EQ(camera.at("elevation"), 35);
    EXPECT_EQ(camera.at("field_of_view"), 25);
    EXPECT_EQ(camera.at("zoom"), 1.5);
    EXPECT_EQ(camera.at("target"), json({0.1, 0.2, -0.3}));
    EXPECT_TRUE(camera.at("distance").is_null());
    // With y up, a camera at azimuth 0 looks along -z, and x is to the right.
    EXPECT_EQ(facts.at("framing").at("back"), json({0, 0, 1}));
    EXPECT_EQ(facts.at("framing").at("right").at(0), 1);
    EXPECT_GT(facts.at("framing").at("margin"), 0);
    EXPECT_EQ(facts.at("framing").at("outline"), 255);
    const TriangleMesh mesh = loadMesh("torus").mesh;
    double foot = 1e9;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        foot = std::min(foot, vertex.y()); // up, as nothing else is said
    }
    EXPECT_EQ(facts.at("up"), json({0, 1, 0}));
    EXPECT_EQ(facts.at("foot"), foot);
    EXPECT_EQ(facts.at("triangles"), mesh.triangles.size());
}

TEST_F(PageFacts, HaveTheRotationsOfPosesRowByRow)
{
    RunHead head = someHead();
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    pose.offset = {4, 5, 6};
    head.poses = {Pose(), pose};
    const json poses = factsOf(head).at("poses");
    ASSERT_EQ(poses.size(), 2U);
    const Eigen::Vector3d point(0.3, -2, 0.8);
    const Eigen::Vector3d turned = pose.rotation * point;
    for (std::size_t row = 0; row < 3; ++row)
    {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
            sum += poses[1][3 * row + k].get<double>() * point[static_cast<Eigen::Index>(k)];
        }
        EXPECT_NEAR(sum, turned[static_cast<Eigen::Index>(row)], 1e-12);
        EXPECT_EQ(poses[1][9 + row], pose.offset[static_cast<Eigen::Index>(row)]);
    }
}

TEST_F(PageFacts, HaveTheColoursOfEveryLook)
{
    const json facts = factsOf(someHead());
    const std::vector<std::pair<std::string, Look>> looks = {{"Clean", Look::clean},
                                                             {"Dark", Look::dark},
                                                             {"Paper", Look::paper},
                                                             {"Studio", Look::studio}};
    ASSERT_EQ(facts.at("looks").size(), looks.size());
    EXPECT_EQ(facts.at("look"), 0);
    for (std::size_t k = 0; k < looks.size(); ++k)
    {
        const json& shown = facts.at("looks")[k];
        const Palette palette = paletteOf(looks[k].second);
        EXPECT_EQ(shown.at("name"), looks[k].first);
        EXPECT_EQ(shown.at("background"), palette.background);
        EXPECT_EQ(shown.at("running"), palette.running);
        EXPECT_EQ(shown.at("frozen"), palette.frozen);
        EXPECT_EQ(shown.at("discarded"), palette.discarded);
        EXPECT_EQ(shown.at("active_polygon"), palette.activePolygon);
        EXPECT_EQ(shown.at("discarded_polygon"), palette.discardedPolygon);
        EXPECT_EQ(shown.at("text"), palette.text);
    }
}

TEST_F(PageFacts, HaveTheScaleFromItsDarkEndAndWhatItMeans)
{
    const json facts = factsOf(someHead());
    ASSERT_EQ(facts.at("scale").size(), 256U);
    EXPECT_EQ(facts.at("scale").front(), json({68, 1, 84, 255})); // the ends of viridis
    EXPECT_EQ(facts.at("scale").back(), json({253, 231, 37, 255}));
    std::map<std::string, json> colours;
    for (const json& each : facts.at("colours"))
    {
        colours[each.at("by").get<std::string>()] = each;
    }
    EXPECT_EQ(colours.at("speed").at("title"), "Speed [m/s]");
    EXPECT_EQ(colours.at("height").at("title"), "Height [mesh unit]");
    // Of 12 groups the last has the number 11; three are a set.
    EXPECT_EQ(colours.at("group").at("high"), 11);
    EXPECT_EQ(colours.at("set").at("high"), 3);
    EXPECT_EQ(colours.at("radius").at("low"), 0.25);
    EXPECT_EQ(colours.at("radius").at("high"), 0.5);
}

TEST_F(PageFacts, HaveThePlanesOfTheCutOrNone)
{
    RunHead head = someHead();
    const json planes = factsOf(head).at("cutaway");
    ASSERT_EQ(planes.size(), 2U);
    // Between the faces both planes take away; opposite neither does.
    for (const double azimuth : {55.0, 235.0})
    {
        const double angle = azimuth * M_PI / 180;
        for (const json& plane : planes)
        {
            const double side = plane[0].get<double>() * std::sin(angle) +
                                plane[2].get<double>() * std::cos(angle) + plane[3].get<double>();
            EXPECT_EQ(side > 0, azimuth < 180);
        }
    }
    head.scene.style.cutaway.kind = Cutaway::Kind::none;
    EXPECT_TRUE(factsOf(head).at("cutaway").is_null());
}

TEST_F(PageFacts, SayHowFarTheShellOfADenseMeshIsFromIt)
{
    const TriangleMesh dense = shapes::torus(1, 0.4, 300, 100);
    const std::string page = pageOf(someHead(), dense);
    const json facts = factsIn(page);
    EXPECT_EQ(facts.at("mesh_triangles"), dense.triangles.size());
    EXPECT_LE(facts.at("triangles"), 20'000U);
    EXPECT_GT(facts.at("shell_distance"), 0);
    EXPECT_LT(facts.at("shell_distance"), 2.8 / 500);
    const std::string full = pageOf(someHead(), dense, true);
    EXPECT_EQ(factsIn(full).at("triangles"), dense.triangles.size());
    EXPECT_FALSE(factsIn(full).contains("shell_distance"));
    EXPECT_LT(page.size(), full.size());
}

TEST_F(PageFacts, CannotEndTheElementThatTheyStandIn)
{
    const auto count = [](const std::string& text, const std::string& word)
    {
        std::size_t times = 0;
        for (std::size_t at = text.find(word); at != std::string::npos;
             at = text.find(word, at + 1))
        {
            ++times;
        }
        return times;
    };
    RunHead head = someHead();
    const std::size_t usual = count(pageOf(head), "</script>");
    head.scene.name = "</script><script>alert('Hello')</script>";
    const std::string page = pageOf(head);
    EXPECT_EQ(count(page, "</script>"), usual);
    EXPECT_EQ(count(page, "<script>alert"), 0U);
    EXPECT_EQ(factsOf(head).at("name"), head.scene.name);
}

} // namespace
} // namespace frostfill
