// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <frostfill/options.hpp>

#include <limits>
#include <set>

namespace frostfill
{
namespace
{

using test::expectError;

TEST(Options, HaveNamesOfTheirOwnAndAllTheirParts)
{
    std::set<std::string> keys;
    std::set<std::string> flags;
    for (const Option& option : sceneOptions())
    {
        EXPECT_TRUE(keys.insert(option.key).second) << option.key;
        EXPECT_TRUE(option.flag.empty() || flags.insert(option.flag).second) << option.flag;
        EXPECT_FALSE(option.help.empty() || option.group.empty()) << option.key;
        EXPECT_TRUE(option.get && option.set) << option.key;
        EXPECT_EQ(findOption(option.key), &option);
    }
    EXPECT_EQ(findOption("no.such.key"), nullptr);
    EXPECT_EQ(&optionOf("spheres.count"), findOption("spheres.count"));
    EXPECT_THROW((void)optionOf("no.such.key"), std::logic_error);
}

TEST(Options, GiveBackOnTheCommandLineWhatTheyAre)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.camera.target = Eigen::Vector3d(0.1, -2, 1e-7);
    scene.spheres.radius = 0.1 + 0.2;
    for (const Option& option : sceneOptions())
    {
        const auto read = readOptionText(option, optionText(option, option.get(scene)));
        ASSERT_TRUE(read) << option.key;
        Scene copy;
        ASSERT_TRUE(setOption(option, copy, *read)) << option.key;
        EXPECT_EQ(option.get(copy), option.get(scene)) << option.key;
    }
}

std::set<std::string> keysFor(OptionUse use)
{
    std::set<std::string> keys;
    for (const Option* option : optionsFor(use))
    {
        EXPECT_TRUE(keys.insert(option->key).second) << option->key;
    }
    return keys;
}

TEST(Options, OfEachUseAreThePartOfTheTableThatChangesItsResult)
{
    EXPECT_EQ(keysFor(OptionUse::filling).size(), sceneOptions().size());
    const std::set<std::string> loading = {"object.cavity", "object.lid", "object.unite",
                                           "object.wrap"};
    EXPECT_EQ(keysFor(OptionUse::loading), loading);
    std::set<std::string> judging = loading;
    judging.insert({"object.up", "judge.friction", "judge.rolling_friction", "judge.unbalance"});
    EXPECT_EQ(keysFor(OptionUse::judging), judging);

    const std::set<std::string> pictures = keysFor(OptionUse::pictures);
    for (const char* key : {"frames.which", "picture.style", "camera.azimuth", "camera.turntable"})
    {
        EXPECT_TRUE(pictures.contains(key)) << key;
    }
    // What decides which states there are cannot change any more when the run is over.
    for (const char* key : {"frames.slow_motion", "frames.duration", "frames.keep_run",
                            "spheres.count", "object.lid", "motion.mode"})
    {
        EXPECT_FALSE(pictures.contains(key)) << key;
    }
}

TEST(Options, TakeWordsForNumbersAndForNothing)
{
    Scene scene;
    const Option& units = *findOption("object.units_per_metre");
    ASSERT_TRUE(setOption(units, scene, *readOptionText(units, "mm")));
    EXPECT_EQ(scene.object.unitsPerMetre, 1000);
    ASSERT_TRUE(setOption(units, scene, *readOptionText(units, "2.5")));
    EXPECT_EQ(scene.object.unitsPerMetre, 2.5);

    const Option& dt = *findOption("motion.dt");
    scene.motion.dt = 0.5;
    ASSERT_TRUE(setOption(dt, scene, *readOptionText(dt, "auto")));
    EXPECT_FALSE(scene.motion.dt);
}

TEST(Options, OneColourIsThatOfSpheresOfAllStates)
{
    const Option& option = *findOption("picture.colour");
    Scene scene;
    const Palette usual = scene.style.palette;
    EXPECT_EQ(optionText(option, option.get(scene)), "by-state");
    EXPECT_TRUE(setOption(option, scene, std::string("by-state")));
    EXPECT_EQ(scene.style.palette.running, usual.running);
    EXPECT_TRUE(setOption(option, scene, std::string("vermilion")));
    const Colour vermilion = {213, 94, 0, 255};
    EXPECT_EQ(scene.style.palette.running, vermilion);
    EXPECT_EQ(scene.style.palette.frozen, vermilion);
    EXPECT_EQ(scene.style.palette.discarded, vermilion);
    EXPECT_EQ(scene.style.palette.activePolygon, usual.activePolygon);
    EXPECT_EQ(optionText(option, option.get(scene)), "#d55e00");
}

TEST(Options, RefuseWhatIsNotOfTheirTypeOrRange)
{
    const auto refused = [](const char* key, const char* text)
    {
        const Option& option = *findOption(key);
        Scene scene;
        const OptionValue before = option.get(scene);
        const auto value = readOptionText(option, text);
        return (!value || !setOption(option, scene, *value)) && option.get(scene) == before;
    };
    EXPECT_TRUE(refused("spheres.radius", "0"));
    EXPECT_TRUE(refused("spheres.radius", "-1"));
    EXPECT_TRUE(refused("spheres.radius", "inf"));
    EXPECT_TRUE(refused("spheres.radius", "nan"));
    EXPECT_TRUE(refused("spheres.radius", "1x"));
    EXPECT_TRUE(refused("spheres.count", "0"));
    EXPECT_TRUE(refused("spheres.count", "1.5"));
    EXPECT_TRUE(refused("spheres.count", "99999999999999999999"));
    EXPECT_TRUE(refused("motion.restitution", "1.01"));
    EXPECT_TRUE(refused("motion.gravity", "auto"));
    EXPECT_TRUE(refused("search.polygons", "octree"));
    EXPECT_TRUE(refused("picture.size", "1280"));
    EXPECT_TRUE(refused("picture.size", "0x0"));
    EXPECT_TRUE(refused("picture.size", "20000x20000"));
    EXPECT_TRUE(refused("picture.size", "-5x5"));
    EXPECT_TRUE(refused("picture.background", "whiter")); // white is a name
    EXPECT_TRUE(refused("picture.colour", "purpel"));
    EXPECT_TRUE(refused("picture.background", "#12345"));
    EXPECT_TRUE(refused("picture.legend", "yes"));
    EXPECT_TRUE(refused("camera.target", "1,2"));
    EXPECT_TRUE(refused("camera.target", "1,2,3,4"));
}

TEST(ValidateScene, NamesTheFirstValueThatMakesNoSenseAndItsRange)
{
    Scene scene = presetScene(Preset::paper, "torus");
    EXPECT_NO_THROW(validateScene(scene));
    scene.motion.restitution = 1.5;
    expectError(
        ErrorCode::usage, [&] { validateScene(scene); }, "motion.restitution", "1.5", "0 to 1");
    scene.motion.restitution = std::numeric_limits<double>::quiet_NaN();
    expectError(
        ErrorCode::usage, [&] { validateScene(scene); }, "motion.restitution");
}

TEST(ValidateScene, AsksForARadiusOrACount)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.spheres.count.reset();
    expectError(
        ErrorCode::usage, [&] { validateScene(scene); }, "--radius", "--count");
}

TEST(PictureOptions, CutawaysAreReadAndWrittenAlike)
{
    const Option& option = *findOption("picture.cutaway");
    Scene scene;
    for (const char* text : {"none", "plane:0,0,1,0", "plane:0.5,-1,2,0.25", "wedge:-30,60"})
    {
        ASSERT_TRUE(setOption(option, scene, std::string(text))) << text;
        EXPECT_EQ(std::get<std::string>(option.get(scene)), text);
    }
    ASSERT_TRUE(setOption(option, scene, std::string("plane:1,0,0")));
    EXPECT_EQ(scene.style.cutaway.offset, 0);
    for (const char* text : {"", "plane", "plane:1,0", "plane:0,0,0", "plane:1,0,0,1,1", "wedge:0",
                             "wedge:90,0", "wedge:0,181", "wedge:0,nan", "plane:1,,0", "ball:1"})
    {
        EXPECT_FALSE(setOption(option, scene, std::string(text))) << text;
    }
}

TEST(PictureOptions, PassesAreReadAndWrittenAlike)
{
    const Option& option = *findOption("frames.passes");
    Scene scene;
    for (const char* text : {"none", "depth", "normal,identity", "depth,normal,identity"})
    {
        if (setOption(option, scene, std::string(text)))
        {
            EXPECT_EQ(std::get<std::string>(option.get(scene)), text);
        }
        else
        {
            ADD_FAILURE() << text;
        }
    }
    EXPECT_TRUE(setOption(option, scene, std::string("all")) && scene.frames.passes.identity);
    for (const char* text : {"", "colour", "depth,", "depth normal"})
    {
        EXPECT_FALSE(setOption(option, scene, std::string(text))) << text;
    }
}

TEST(PictureOptions, AStyleBringsItsColoursAndGivenOnesComeAfterIt)
{
    const Scene scene = parseScene("[picture]\nbackground = '#123456'\nstyle = 'dark'\n", "test");
    EXPECT_EQ(scene.style.palette.background, (Colour{0x12, 0x34, 0x56, 255}));
    EXPECT_EQ(scene.style.palette.text, paletteOf(Look::dark).text);
    const Scene again = parseScene(sceneToToml(scene), "again");
    EXPECT_EQ(again.style.palette.background, scene.style.palette.background);
    EXPECT_EQ(again.style.palette.frozen, scene.style.palette.frozen);
}

TEST(PictureOptions, NoBackgroundIsThatOfTheStyleWithoutItsAlpha)
{
    for (const char* word : {"none", "transparent"})
    {
        Scene scene = parseScene("[picture]\nstyle = 'dark'\n", "test");
        const Colour dark = scene.style.palette.background;
        ASSERT_TRUE(setOption(*findOption("picture.background"), scene, std::string(word)));
        EXPECT_EQ(scene.style.palette.background, (Colour{dark[0], dark[1], dark[2], 0}));
        const Scene again = parseScene(sceneToToml(scene), "again");
        EXPECT_EQ(again.style.palette.background, scene.style.palette.background);
    }
}

TEST(ValidateScene, LetsOnlyTheDynamicsOfThePresetFastMoveTheObject)
{
    for (double MoveSettings::*how :
         {&MoveSettings::tilt, &MoveSettings::turn, &MoveSettings::shake})
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.move.*how = 0.1;
        for (const Motion motion : {Motion::fall, Motion::skip})
        {
            scene.motion.mode = motion;
            EXPECT_NO_THROW(validateScene(scene));
        }
        scene.motion.mode = Motion::descend;
        test::expectError(
            ErrorCode::usage, [&] { validateScene(scene); }, "move.tilt", "--motion");
        Scene paper = presetScene(Preset::paper, "torus");
        EXPECT_NO_THROW(validateScene(paper));
        paper.move.*how = 0.1;
        test::expectError(
            ErrorCode::usage, [&] { validateScene(paper); }, "move.tilt", "preset fast");
    }
}

} // namespace
} // namespace frostfill
