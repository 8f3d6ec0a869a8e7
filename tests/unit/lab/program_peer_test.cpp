// SPDX-License-Identifier: MIT
// Engines that are programs of their own. They are scripts here, told what to do by lines.
#include "lab/program_peer.hpp"

#include "lab/meshes.hpp"
#include "lab/pouring.hpp"
#include "lab/study.hpp"
#include "support/expect_error.hpp"
#include "support/small_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

using test::expectError;

/// Free fall from rest by symplectic Euler onto a plane at y = -6, where each sphere stops.
constexpr const char* kFall = R"(n=0 size=0 spheres=
while read -r verb a b c; do
  case $verb in
    step) if [ -n "$a" ]; then dt=$a; else n=$((n + 1)); fi ;;
    start) echo ready ;;
    add) size=$((size + 1)) spheres="$spheres$a $b $c $n
" ;;
    places) echo places $size
      printf %s "$spheres" | awk -v n=$n -v dt=$dt '{ k = n - $4; y = $2 - dt * dt * k * (k + 1) / 2
        printf "%s %.17g %s\n", $1, y < -5 ? -5 : y, $3 }' ;;
    end) exit ;;
  esac
done
)";

/// As a loop that answers `start` and `places` by what is given.
std::string answering(const std::string& start, const std::string& places,
                      const std::string& step = ":")
{
    return fmt::format("n=0\nwhile read -r verb a b c; do case $verb in\n"
                       "start) {};;\nadd) n=$((n + 1));;\nstep) test -n \"$a\" || {{ {}; "
                       "}};;\nplaces) {};;\nend) exit;;\n"
                       "esac; done\n",
                       start, step, places);
}
const std::string kStill =
    "echo places $n; awk -v n=$n 'BEGIN { for (k = 0; k < n; ++k) print 2 * k - 4, -5, 0 }'";

class ProgramPeers : public testing::Test
{
protected:
    ProgramPeers()
    {
        task_.mesh = cutBoxMesh({-6, -6, -6}, {6, 6, 6}, 2);
        task_.count = 5;
        task_.restitution = 0.2;
        task_.secondsLimit = 3; // and ten times that by the clock
    }
    [[nodiscard]] ProgramPeer engine(const std::string& script) const
    {
        return {"Mine", test::writeProgram(folder_ / "engine", script)};
    }
    [[nodiscard]] PeerResult run(const std::string& script, double step = 0.1) const
    {
        return runProgramPeer(engine(script), task_, step);
    }
    template <typename... Parts>
    void expectRefused(const std::string& script, const Parts&... parts) const
    {
        expectError(
            ErrorCode::missingProgram, [&] { static_cast<void>(run(script)); }, "the engine Mine",
            parts...);
    }
    PeerTask task_;
    test::TemporaryFolder folder_;
};

TEST_F(ProgramPeers, FallAsTheClosedFormSays)
{
    const std::vector<Eigen::Vector3d> from = Pouring(task_).next({});
    ASSERT_EQ(from.size(), task_.count);
    const double step = 0.0625;
    task_.timeLimit = 2;
    const PeerResult falling = run(kFall, step);
    EXPECT_FALSE(falling.atRest);
    EXPECT_EQ(falling.simulated, task_.timeLimit);
    ASSERT_EQ(falling.places.size(), task_.count);
    for (std::size_t k = 0; k < task_.count; ++k)
    {
        EXPECT_EQ(falling.places[k].x(), from[k].x()); // 17 digits are all of them
        EXPECT_EQ(falling.places[k].z(), from[k].z());
        EXPECT_NEAR(falling.places[k].y(), from[k].y() - 2 * (2 + step) / 2, 1e-12);
    }
    task_.timeLimit = 400;
    const PeerResult fallen = run(kFall, step);
    EXPECT_TRUE(fallen.atRest);
    double highest = 0;
    for (std::size_t k = 0; k < task_.count; ++k)
    {
        highest = std::max(highest, from[k].y() + 5);
        EXPECT_EQ(fallen.places[k], Eigen::Vector3d(from[k].x(), -5, from[k].z()));
    }
    // The last one is down, and two looks are a window apart at most.
    EXPECT_NEAR(fallen.simulated, std::sqrt(2 * highest) + 1.5 * kPeerWindow, 1.5 * kPeerWindow);
}

TEST_F(ProgramPeers, AreToldAllThatTheTaskSays)
{
    task_.mesh = {{{0.1, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}},
                  {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    task_.count = 0;
    task_.friction = 0.5;
    task_.timeLimit = 0.3;
    const std::string copy = "tee '" + (folder_ / "told").string() + "' | ";
    static_cast<void>(run(copy + "while read -r verb rest; do case $verb in start) echo ready;; "
                                 "places) echo places 0;; esac; done\n",
                          0.25));
    const std::string told = test::readFile(folder_ / "told");
    EXPECT_EQ(told, "frostfill-peer 1\n"
                    "restitution 0.20000000000000001\n"
                    "friction 0.5\n"
                    "step 0.25\n"
                    "bounce 0.5\n"
                    "still 0.090909090909090898\n"
                    "spheres 0\n"
                    "vertices 4\n"
                    "0.10000000000000001 0 0\n9 0 0\n0 9 0\n0 0 9\n"
                    "triangles 4\n0 2 1\n0 1 3\n0 3 2\n1 2 3\n"
                    "start\nstep\nplaces\nplaces\nend\n");
}

TEST_F(ProgramPeers, ThatCannotBeStartedAreRefused)
{
    for (const auto& [program, why] :
         {std::pair{folder_ / "missing", "No such file"}, std::pair{folder_.path(), "denied"}})
    {
        expectError(
            ErrorCode::missingProgram,
            [&, name = program] {
                tryProgramPeer({"Mine", name.string()});
            },
            "the engine Mine cannot be started", program.string(), why);
    }
}

TEST_F(ProgramPeers, ThatEndAreRefusedWithTheirLastWords)
{
    expectRefused("echo loading >&2; printf 'no \\033[1mGPU\\n' >&2; exit 3\n",
                  "was to answer 'ready', but ended with code 3",
                  "; its errors end with: loading no [1mGPU");
    expectRefused(answering("echo ready", "kill -KILL $$"),
                  "was to answer 'places 0', but was ended by signal 9");
    expectRefused(answering("echo ready", "echo places $n", "exit 4"),
                  "was to answer 'places 5', but ended with code 4");
}

TEST_F(ProgramPeers, ThatSaySomethingElseAreRefused)
{
    expectRefused(answering("echo hello", kStill), "was to answer 'ready', but said 'hello'");
    expectRefused(answering("echo", kStill), "but said ''");
    expectRefused(
        answering("echo 'Jolt is quite ready for whatever you may have in mind, I say'", kStill),
        "but said 'Jolt is quite ready for whatever you may have in mind, I say'");
    expectRefused(
        answering("echo 0123456789012345678901234567890123456789012345678901234567890", kStill),
        "...'");
    expectRefused(answering("echo ready; echo ready", kStill),
                  "was to answer 'places 0', but said 'ready'");
    expectRefused(answering("echo ready", "echo places 7"),
                  "was to answer 'places 0', but said 'places 7'");
}

TEST_F(ProgramPeers, WhoseNumbersAreNoneAreRefused)
{
    task_.count = 1;
    for (const char* place :
         {"1 2", "1 2 three", "1 2 3 4", "1 2 nan", "1 inf 3", "1,2,3", "", "1 2-3", "1e999 2 3"})
    {
        expectRefused(answering("echo ready", fmt::format("echo places $n; test $n = 0 || "
                                                          "echo '{}'",
                                                          place)),
                      "was to answer three numbers for sphere 0, but said '",
                      std::string("'") + place + "'");
    }
    const PeerResult result = run(
        answering("echo ready", "echo places $n; test $n = 0 || printf ' 1e0\\t-2.5 3 \\r\\n'"));
    ASSERT_EQ(result.places.size(), 1U);
    EXPECT_EQ(result.places[0], Eigen::Vector3d(1, -2.5, 3));
}

TEST_F(ProgramPeers, ThatHangAreEnded)
{
    task_.secondsLimit = 0.05;
    expectRefused("sleep 60\n", "was to answer 'ready', but has not answered within 0.5 s");
    expectRefused(answering("echo ready", kStill, "sleep 60"), "but has not answered within 0.5 s");
}

TEST_F(ProgramPeers, ThatFloodAreRefused)
{
    expectRefused("yes ready\n", "was to answer 'places 0', but said 'ready'");
    expectRefused("tr '\\0' x </dev/zero\n", "but says more than it was asked for");
}

TEST_F(ProgramPeers, EndWhenTheirProcessorTimeIsUsedUp)
{
    task_.secondsLimit = 0.3;
    const auto burn = "k=0; while [ $k -lt 100000 ]; do k=$((k + 1)); done";
    const PeerResult burnt =
        run(answering("echo ready",
                      "looks=$((looks + 1)); echo places $n; awk -v n=$n -v y=$looks "
                      "'BEGIN { for (k = 0; k < n; ++k) print 2 * k - 4, y, 0 }'",
                      burn),
            0.01);
    EXPECT_FALSE(burnt.atRest);
    EXPECT_LT(burnt.simulated, kPeerWindow); // no second look was waited for
    EXPECT_GE(burnt.seconds, task_.secondsLimit);
    // One that sleeps for longer has used none of it.
    const PeerResult slept = run(answering("echo ready", "sleep 0.1; " + kStill));
    EXPECT_TRUE(slept.atRest);
    EXPECT_LT(slept.seconds, task_.secondsLimit);
}

TEST_F(ProgramPeers, AreNamedByAnEqualsSign)
{
    const ProgramPeer peer = readProgramPeers({"My engine 2=/opt/a=b"}).at(0);
    EXPECT_EQ(peer.name, "My engine 2");
    EXPECT_EQ(peer.program, "/opt/a=b");
    for (const char* wrong : {"Jolt", "=jolt", "Jolt=", "=", ""})
    {
        expectError(
            ErrorCode::usage, [&] { static_cast<void>(readProgramPeers({wrong})); },
            std::string("'") + wrong + "' must be NAME=PROGRAM");
    }
    for (const char* odd : {"a,b=c", "a\"=c", "a\n=c", "{a}=c"})
    {
        expectError(
            ErrorCode::usage, [&] { static_cast<void>(readProgramPeers({odd})); },
            "cannot name an engine");
    }
    EXPECT_EQ(readProgramPeers({"A=a", "B=a"}).size(), 2U);
    for (const char* taken : {"Frostfill", "A"})
    {
        const std::string text = fmt::format("{}=b", taken);
        expectError(
            ErrorCode::usage,
            [&] {
                static_cast<void>(readProgramPeers({"A=a", text}));
            },
            fmt::format("two engines have the name {}", taken));
    }
}

TEST_F(ProgramPeers, AreTriedBeforeTheyAreCompared)
{
    EXPECT_NO_THROW(tryProgramPeer(engine(kFall)));
    expectError(
        ErrorCode::missingProgram, [&] { tryProgramPeer(engine("exit 5\n")); },
        "ended with code 5");
}

TEST_F(ProgramPeers, StandBesideTheOtherEngines)
{
    // A lattice of a height of 10 radii, whose layers are one radius apart.
    const auto points = measurePeers(
        true,
        {engine(answering("echo ready",
                          "echo places $n; awk -v n=$n 'BEGIN { for (k = 0; k < n; ++k) print "
                          "2 * (k % 10) - 9, int(k / 100) - 9, 2 * int(k / 10 % 10) - 9 }'"))},
        [](std::size_t, std::size_t, const std::string&) {});
    ASSERT_EQ(points.size(), 5U);
    for (const std::size_t k : {3, 4})
    {
        EXPECT_EQ(points[k].engine, "Mine");
        EXPECT_EQ(points[k].setting, k == 3 ? "step 0.12" : "step 0.06");
        EXPECT_FALSE(points[k].ours);
        EXPECT_TRUE(points[k].atRest);
        EXPECT_EQ(points[k].missing, 0U);
        EXPECT_EQ(points[k].outside, 0U);
        EXPECT_NEAR(points[k].maxOverlap, 1, 1e-9);
    }
    EXPECT_EQ(peersCsv(points).rows.back().front(), "Mine");
}

} // namespace
} // namespace frostfill
