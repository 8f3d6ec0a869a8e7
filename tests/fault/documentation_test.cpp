// SPDX-License-Identifier: MIT
// Runs every command that the README and docs/ show, with few spheres and small
// pictures, in the order in which they are shown; and follows every link
// between their files.

#include "fault/program.hpp"
#include "fault/shown_commands.hpp"
#include "support/paths.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;
using test::argumentsOf;
using test::commandsOf;
using test::madeSmall;
using test::readFile;

#ifdef FROSTFILL_WRAP_PROGRAM
constexpr bool kHasWrap = true; // beside the program, which finds it there
#else
constexpr bool kHasWrap = false;
#endif

const bool kHasLiggghts = std::system("command -v liggghts >/dev/null 2>&1") == 0;
const std::filesystem::path kSource = testing_support::sourceFolder();

std::vector<std::filesystem::path> pages()
{
    std::vector<std::filesystem::path> found = {kSource / "README.md", kSource / "CONTRIBUTING.md"};
    for (const auto& file : std::filesystem::directory_iterator(kSource / "docs"))
    {
        if (file.path().extension() == ".md")
        {
            found.push_back(file.path());
        }
    }
    std::sort(found.begin() + 1, found.end());
    return found;
}

void prepare(const std::filesystem::path& folder)
{
    std::filesystem::copy_file(kSource / "meshes/torus.obj", folder / "bunny.obj");
    ASSERT_EQ(test::runProgram("mesh cube --repair part.ply", folder).code, 0);
    // An STL of its own: a tetrahedron.
    test::writeFile(folder / "part.stl",
                    "solid part\n"
                    "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 9 "
                    "0\nvertex 9 0 0\n"
                    "endloop\nendfacet\n"
                    "facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 9 0 "
                    "0\nvertex 0 0 9\n"
                    "endloop\nendfacet\n"
                    "facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 "
                    "9\nvertex 0 9 0\n"
                    "endloop\nendfacet\n"
                    "facet normal 1 1 1\nouter loop\nvertex 9 0 0\nvertex 0 9 "
                    "0\nvertex 0 0 9\n"
                    "endloop\nendfacet\n"
                    "endsolid part\n");
    // A square cup with a wall. OFF files are known by their first word.
    test::writeFile(folder / "cup.stl",
                    "OFF\n16 14 0\n0 0 0\n1 0 0\n1 0 1\n0 0 1\n0 1 0\n1 1 0\n1 1 1\n0 1 1\n"
                    ".1 .1 .1\n.9 .1 .1\n.9 .1 .9\n.1 .1 .9\n.1 1 .1\n.9 1 .1\n.9 1 .9\n.1 1 "
                    ".9\n"
                    "4 0 1 2 3\n4 0 4 5 1\n4 1 5 6 2\n4 2 6 7 3\n4 3 7 4 0\n"
                    "4 8 11 10 9\n4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n"
                    "4 4 12 13 5\n4 5 13 14 6\n4 6 14 15 7\n4 7 15 12 4\n");
    // A tetrahedron in two patches.
    const std::string corners = "OFF\n4 2 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n";
    test::writeFile(folder / "wall.stl", corners + "3 0 2 1\n3 0 1 3\n");
    test::writeFile(folder / "lid.stl", corners + "3 0 3 2\n3 1 2 3\n");
    test::writeFile(folder / "packing.csv", "x,y,z,radius\n1.5,1.5,0.5,0.5\n");
    test::writeFile(folder / "sieve.csv",
                    "diameter, cumulative mass\n4, 0\n5, 25\n6, 60\n8, 100\n");
    test::writeFile(folder / "gaps.csv", "radius, volume share\n0.2, 0.66\n0.5, 0.34\n");
    test::writeFile(folder / "beads.csv", "px,py,pz,size\n0,-0.5,0,1\n");
    test::writeFile(folder / "grains.txt", "0 -0.5 0 0.5\n0.2 0.6 0 0.25\n");
    const auto dumpStep = [](const char* step)
    {
        return std::string("ITEM: TIMESTEP\n") + step +
               "\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 "
               "9\n"
               "ITEM: ATOMS id type x y z radius\n1 1 1.5 1.5 0." +
               step + " 0.5\n";
    };
    test::writeFile(folder / "dump.lammpstrj", dumpStep("5") + dumpStep("6"));
    test::writeFile(folder / "scene.toml", "[object]\nmesh = \"cube\"\n[spheres]\ncount = 6\n");
    test::writeFile(folder / "sweep.toml",
                    "[scene]\nframes.which = \"none\"\n[sweep]\nobject.mesh = [\"cube\", "
                    "\"torus\"]\nspheres.radius = [0.3]\n");
    std::filesystem::create_directories(folder / "docs"); // of a clone
    // What scripts/run leaves behind.
    ASSERT_EQ(test::runProgram("fill torus --count 6 --frames none --quiet", folder).code, 0);
}

/// What draws a run again, goes on with it or measures it. Others may have
/// replaced it by one without pictures.
bool needsKeptRun(const std::string& arguments)
{
    return arguments.find("output/torus") != std::string::npos &&
           arguments.find("summary.json") == std::string::npos;
}

/// Runs a command of frostfill-lab with little to do, or asks for its help only: most take most of
/// a minute.
void expectMeasurementWorks(const std::string& command, const std::filesystem::path& folder,
                            bool measures)
{
    const std::size_t from = command.find(' ');
    const std::string arguments = command.substr(from, command.find("  ") - from);
    const Answer answer =
        test::runProgram(arguments + (measures ? " --quick --out lab" : " --help"), folder, "",
                         FROSTFILL_LAB_PROGRAM);
    const bool lacksEngine = arguments.find("--peer") != std::string::npos && answer.code == 69;
    EXPECT_TRUE(answer.code == 0 || lacksEngine) << command << "\n" << answer.errors;
}

/// Runs what is shown of frostfill-lab, or of the program.
void expectShownCommandsWork(bool ofTheLab)
{
    const test::TemporaryFolder folder;
    prepare(folder.path());
    std::set<std::string> run;
    std::set<std::string> names;
    for (const auto& page : pages())
    {
        for (const std::string& command : commandsOf(readFile(page)))
        {
            if (command.rfind("cd ", 0) == 0)
            {
                const auto inFolder = "cd '" + folder.path().string() + "' && ";
                EXPECT_TRUE(ofTheLab || !kHasLiggghts ||
                            std::system((inFolder + command + " >/dev/null 2>&1").c_str()) == 0)
                    << page.filename() << " shows: " << command;
                continue;
            }
            // What several pages show is run once.
            if (command.rfind("frostfill-lab ", 0) == 0)
            {
                if (run.insert(command).second)
                {
                    expectMeasurementWorks(command, folder.path(), ofTheLab);
                }
                continue;
            }
            const std::string arguments = madeSmall(argumentsOf(command));
            names.insert(arguments.substr(0, arguments.find(' ')));
            const bool lacksDump =
                !kHasLiggghts && arguments.find("liggghts.dump") != std::string::npos;
            if (ofTheLab || lacksDump || !run.insert(arguments).second)
            {
                continue;
            }
            if (needsKeptRun(arguments))
            {
                EXPECT_EQ(test::runProgram("fill torus --count 6 --size 64x48 --duration 0.3 "
                                           "--quiet --overwrite",
                                           folder.path())
                              .code,
                          0);
            }
            if (arguments.find("render output/torus --gather") == 0)
            {
                EXPECT_EQ(
                    test::runProgram("render output/torus --size 64x48 --overwrite", folder.path())
                        .code,
                    0);
            }
            const Answer answer = test::runProgram(arguments, folder.path());
            // Without the program for skins or ffmpeg, nothing runs.
            const bool lacksWrap =
                !kHasWrap && (arguments.find("--wrap") != std::string::npos ||
                              arguments.find("object.unite=true") != std::string::npos);
            const bool makesVideo = arguments.find("--video") != std::string::npos ||
                                    arguments.find(".mp4") != std::string::npos ||
                                    arguments.find(".gif") != std::string::npos;
            const bool lacksFfmpeg =
                makesVideo && std::system("command -v ffmpeg >/dev/null 2>&1") != 0;
            EXPECT_TRUE(answer.code == 0 || (lacksFfmpeg && answer.code == 73) ||
                        (lacksWrap && answer.code == 69))
                << page.filename() << " shows: " << command << "\nrun as: " << arguments << "\n"
                << answer.errors;
        }
    }
    const auto commands = test::commandsOfHelp(test::runProgram("--help", folder.path()).output);
    EXPECT_GE(commands.size(), 12U);
    for (const std::string& name : commands)
    {
        EXPECT_EQ(names.count(name), 1u) << "no page shows frostfill " << name;
    }
    EXPECT_GE(run.size(), 3u);
}

TEST(Documentation, EveryCommandThatIsShownWorks)
{
    expectShownCommandsWork(false);
}

TEST(Documentation, EveryMeasurementThatIsShownWorks) // with the label `long`
{
    expectShownCommandsWork(true);
}

/// The file's text with comments that go on in the next line joined, so that no
/// key is cut in two.
std::string joinedText(const std::filesystem::path& file)
{
    static const std::regex kNextLine("\\n[ \\t]*(//+<?|#|\\*)?[ \\t]*");
    return std::regex_replace(readFile(file), kNextLine, " ");
}

/// What is cited: "[Verlet 1967]", "[Ericson 2005, 5.1.5]", "[RFC
/// 1951, 3.2.6]".
std::set<std::string> citedIn(const std::string& text)
{
    static const std::regex kCitation(
        "\\[((?:van (?:der )?)?[A-Z][A-Za-z&,. ]* (?:18|19|20)[0-9]{2}|"
        "RFC [0-9]{4}|PNG 3rd edition)[^\\]\\[]*\\]");
    std::set<std::string> keys;
    for (std::sregex_iterator it(text.begin(), text.end(), kCitation), end; it != end; ++it)
    {
        keys.insert((*it)[1].str());
    }
    return keys;
}

TEST(Documentation, EveryCitationIsInTheListOfReferences)
{
    EXPECT_EQ(citedIn("the [Author & Other 2001, 3.1] and [van Somebody 1999]"),
              (std::set<std::string>{"Author & Other 2001", "van Somebody 1999"}));
    const std::set<std::string> listed = citedIn(readFile(kSource / "docs/references.md"));
    static const std::set<std::string> kTexts = {".hpp",  ".cpp",  ".md",   ".gp",
                                                 ".glsl", ".vert", ".frag", ".txt"};
    std::set<std::string> cited;
    for (const char* folder : {"src", "include", "tests", "tools", "shaders", "docs"})
    {
        for (const auto& file : std::filesystem::recursive_directory_iterator(kSource / folder))
        {
            if (kTexts.count(file.path().extension().string()) == 0 ||
                file.path().filename() == "references.md" ||
                file.path().filename() == "documentation_test.cpp")
            {
                continue;
            }
            for (const std::string& key : citedIn(joinedText(file.path())))
            {
                EXPECT_EQ(listed.count(key), 1u)
                    << file.path() << " cites [" << key << "], which docs/references.md lacks";
                cited.insert(key);
            }
        }
    }
    EXPECT_GT(cited.size(), 15u);
}

/// Whether a folder of src/ has headers of its own, not counting those of the
/// rooms in it.
bool hasHeaders(const std::filesystem::path& room)
{
    const std::filesystem::directory_iterator files(room);
    return std::any_of(begin(files), end(files),
                       [](const auto& file) { return file.path().extension() == ".hpp"; });
}

TEST(Documentation, TheFirstHeaderOfEachRoomSaysWhatTheRoomIs)
{
    const std::string page = readFile(kSource / "docs/architecture.md");
    static const std::regex kRow("\n\\| `([a-z_/]+)` \\| `([a-z_/0-9]+\\.hpp)` \\|");
    std::set<std::string> rooms;
    for (std::sregex_iterator it(page.begin(), page.end(), kRow), end; it != end; ++it)
    {
        const std::string room = (*it)[1].str();
        const std::string header = (*it)[2].str();
        rooms.insert(room);
        const bool isPublic = header.find('/') != std::string::npos;
        if (!isPublic && !hasHeaders(kSource / "src" / room))
        {
            continue;
        }
        const auto file = isPublic ? kSource / "include" / header : kSource / "src" / room / header;
        EXPECT_EQ(readFile(file).rfind("// SPDX-License-Identifier: MIT\n// Room: ", 0), 0u)
            << file << " does not say what the room is";
    }
    // The rooms are those of the layout test.
    const std::string layout = readFile(kSource / "tests/layout/check_rooms.cmake");
    static const std::regex kRoom("\nroom\\(([a-z_/]+)");
    for (std::sregex_iterator it(layout.begin(), layout.end(), kRoom), end; it != end; ++it)
    {
        EXPECT_EQ(rooms.count((*it)[1].str()), 1u)
            << "docs/architecture.md lacks the room " << (*it)[1];
    }
}

/// A page without its blocks of code, in which brackets mean other things.
std::string withoutCode(const std::string& page)
{
    static const std::regex kBlock("```[^`]*```");
    return std::regex_replace(page, kBlock, "");
}

/// The anchors of a page's headings, as web sites make them: "#how-it-is-kept".
std::set<std::string> anchorsOf(const std::string& page)
{
    static const std::regex kHeading("\n#+ ([^\n]+)");
    const std::string text = "\n" + withoutCode(page);
    std::set<std::string> anchors;
    for (std::sregex_iterator it(text.begin(), text.end(), kHeading), end; it != end; ++it)
    {
        std::string anchor;
        for (const unsigned char c : (*it)[1].str())
        {
            if (std::isalnum(c) != 0 || c == '-' || c == '_' || c == ' ')
            {
                anchor += c == ' ' ? '-' : static_cast<char>(std::tolower(c));
            }
        }
        anchors.insert(anchor);
    }
    return anchors;
}

TEST(Documentation, EveryLinkLeadsToAFileAndAHeading)
{
    static const std::regex kLink("\\]\\(([^)#]*)(#[^)]+)?\\)");
    std::size_t links = 0;
    std::size_t anchors = 0;
    for (const auto& page : pages())
    {
        const std::string text = withoutCode(readFile(page));
        for (std::sregex_iterator it(text.begin(), text.end(), kLink), end; it != end; ++it)
        {
            const std::string target = (*it)[1].str();
            if (target.find("://") != std::string::npos)
            {
                continue;
            }
            const auto file = target.empty() ? page : page.parent_path() / target;
            ASSERT_TRUE(std::filesystem::exists(file)) << page.filename() << " links to " << target;
            ++links;
            if ((*it)[2].matched)
            {
                ++anchors;
                EXPECT_EQ(anchorsOf(readFile(file)).count((*it)[2].str().substr(1)), 1U)
                    << page.filename() << " links to " << target << (*it)[2];
            }
        }
    }
    EXPECT_GT(links, 100U);
    EXPECT_GT(anchors, 10U);
}

TEST(Documentation, IsShort)
{
    std::size_t lines = 0;
    for (const auto& page : pages())
    {
        const std::string text = readFile(page);
        const auto count = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
        lines += page.filename() == "CONTRIBUTING.md" ? 0 : count;
        if (page.filename() == "README.md")
        {
            EXPECT_LE(count, 100U);
        }
    }
    EXPECT_LT(lines, 2500U);
}

} // namespace
} // namespace frostfill
