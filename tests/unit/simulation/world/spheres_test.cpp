// SPDX-License-Identifier: MIT
#include "simulation/world/spheres.hpp"

#include "base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

const Vector3d kStill = Vector3d::Zero();

/// What a sphere is, told one by one.
struct Model
{
    Vector3d place;
    Vector3d velocity = kStill;
    double radius = 1;
    std::uint32_t group = 0;
    SphereState state = SphereState::running;
    std::string note; ///< in a column of the test's own
};

/// The table and the model, changed alike.
class SpheresTest : public ::testing::Test
{
protected:
    void add()
    {
        const Vector3d place = point();
        const double radius = 0.5 + draw() / 2;
        const auto group = static_cast<std::uint32_t>(model.size() / 7);
        const bool runs = draw() < 0.9;
        const std::uint32_t id =
            runs ? spheres.add(place, radius, group) : spheres.addResting(place, radius, group);
        ASSERT_EQ(id, model.size());
        const SphereState state = runs ? SphereState::running : SphereState::frozen;
        model.push_back({place, kStill, radius, group, state, ""});
        if (runs)
        {
            EXPECT_EQ(notes[spheres.row(id)], "new");
            note(id, std::to_string(++notesWritten));
            model[id].velocity = point();
            spheres.running().velocity[spheres.row(id)] = model[id].velocity;
        }
    }

    void note(std::uint32_t id, const std::string& text)
    {
        model[id].note = text;
        notes[spheres.row(id)] = text;
    }

    void freeze(std::uint32_t id)
    {
        model[id].place = point();
        const std::uint32_t row = spheres.freeze(id, model[id].place);
        EXPECT_EQ(spheres.resting().id(row), id);
        model[id].velocity = kStill;
        model[id].state = SphereState::frozen;
        changes.push_back(id);
    }

    void wake(std::uint32_t id)
    {
        spheres.wake(id);
        EXPECT_EQ(notes[spheres.row(id)], "new");
        model[id].state = SphereState::running;
        note(id, std::to_string(++notesWritten));
        changes.push_back(id);
    }

    void withdraw(std::uint32_t id)
    {
        const auto last = static_cast<std::uint32_t>(model.size() - 1);
        EXPECT_EQ(spheres.withdraw(id), last);
        const std::uint32_t group = model[id].group;
        model[id] = model[last];
        model[id].group = group;
        model.pop_back();
    }

    /// A random change that the sphere's state allows.
    void change(std::uint32_t id)
    {
        if (model[id].state == SphereState::running)
        {
            draw() < 0.8 ? freeze(id) : withdraw(id);
        }
        else if (draw() < 0.5)
        {
            wake(id);
        }
        else if (model[id].state == SphereState::frozen)
        {
            spheres.discard(id);
            model[id].state = SphereState::discarded;
        }
    }

    void expectSame()
    {
        ASSERT_EQ(spheres.size(), model.size());
        std::size_t running = 0;
        std::size_t discarded = 0;
        for (std::uint32_t id = 0; id < model.size(); ++id)
        {
            const Model& expected = model[id];
            EXPECT_EQ(spheres.state(id), expected.state);
            EXPECT_EQ(spheres.position(id), expected.place);
            EXPECT_EQ(spheres.velocity(id), expected.velocity);
            EXPECT_EQ(spheres.radius(id), expected.radius);
            EXPECT_EQ(spheres.group(id), expected.group);
            const bool runs = expected.state == SphereState::running;
            EXPECT_EQ(spheres.isRunning(id), runs);
            const std::uint32_t row = spheres.row(id);
            EXPECT_EQ(runs ? spheres.running().id[row] : spheres.resting().id(row), id);
            if (runs)
            {
                EXPECT_EQ(notes[row], expected.note);
            }
            running += runs ? 1 : 0;
            discarded += expected.state == SphereState::discarded ? 1 : 0;
        }
        EXPECT_EQ(spheres.runningCount(), running);
        EXPECT_EQ(spheres.discardedCount(), discarded);
        EXPECT_EQ(spheres.frozenCount(), model.size() - running - discarded);
        EXPECT_EQ(spheres.resting().size(), model.size() - running);
    }

    /// That the grid finds each sphere at rest once, where it is.
    void expectFound()
    {
        std::vector<std::uint32_t> found;
        spheres.resting().forEachNear(
            {5, 5, 5}, 100, [&](std::uint32_t row) { found.push_back(spheres.resting().id(row)); });
        std::sort(found.begin(), found.end());
        std::vector<std::uint32_t> expected;
        for (std::uint32_t id = 0; id < model.size(); ++id)
        {
            if (model[id].state != SphereState::running)
            {
                expected.push_back(id);
                bool near = false;
                spheres.resting().forEachNear(model[id].place, 0.01,
                                              [&](std::uint32_t row)
                                              { near = near || spheres.resting().id(row) == id; });
                EXPECT_TRUE(near) << id;
            }
        }
        EXPECT_EQ(found, expected);
    }

    double draw() { return uniformRandom(11, 1, ++draws); }
    Vector3d point()
    {
        const double x = 10 * draw();
        const double y = 10 * draw();
        return {x, y, 10 * draw()};
    }

    Spheres spheres{GridFrame{{0, 0, 0}, 2, {5, 5, 5}}};
    RunningColumn<std::string> notes{spheres.running(),
                                     [](std::uint32_t, std::string& text) { text = "new"; }};
    std::vector<Model> model;
    std::vector<std::uint32_t> changes;
    int notesWritten = 0;
    std::uint64_t draws = 0;
};

TEST_F(SpheresTest, IsWhatAModelIsThatKnowsNoRows)
{
    for (int round = 0; round < 300; ++round)
    {
        SCOPED_TRACE(round);
        for (double k = 6 * draw(); k > 1; --k)
        {
            add();
        }
        for (double k = 6 * draw(); k > 1 && !model.empty(); --k)
        {
            change(static_cast<std::uint32_t>(draw() * static_cast<double>(model.size())));
        }
        expectSame(); // with gaps in the ranks
        spheres.closeRanks();
        expectSame();
        EXPECT_EQ(spheres.running().size(), spheres.runningCount());
        expectFound();
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_GT(spheres.runningCount(), 20u);
    EXPECT_GT(spheres.discardedCount(), 20u);
}

// Results depend on the order of the rows.
TEST_F(SpheresTest, RowsStayUntilTheRanksCloseAndThenTheLastOnesFillTheGaps)
{
    for (std::uint32_t id = 0; id < 6; ++id)
    {
        spheres.add(point(), 1, 0);
    }
    const RunningSpheres& running = spheres.running();
    spheres.freeze(1);
    spheres.freeze(5);
    spheres.freeze(2);
    EXPECT_TRUE(running.isGone(1));
    EXPECT_EQ(spheres.row(4), 4u);
    spheres.closeRanks();
    ASSERT_EQ(running.size(), 3u);
    EXPECT_EQ(running.id[0], 0u);
    EXPECT_EQ(running.id[1], 3u); // 4 came to row 2 first, and 3 is the last that is left
    EXPECT_EQ(running.id[2], 4u);
    std::vector<std::uint32_t> changed;
    std::size_t seen = 0;
    spheres.forEachChangedSince(seen, [&](std::uint32_t id) { changed.push_back(id); });
    EXPECT_EQ(changed, (std::vector<std::uint32_t>{1, 5, 2}));
}

TEST_F(SpheresTest, AColumnKeepsTheMemoryOfRowsThatAreGone)
{
    RunningColumn<std::vector<int>> column(spheres.running());
    spheres.add(point(), 1, 0);
    spheres.add(point(), 1, 0);
    column[0] = {7, 8, 9};
    spheres.freeze(0);
    spheres.closeRanks();
    EXPECT_EQ(column.all().size(), 1u);
    EXPECT_TRUE(column[0].empty()) << "it belongs to sphere 1";
    spheres.add(point(), 1, 0);
    EXPECT_EQ(column[1], (std::vector<int>{7, 8, 9}));
}

TEST_F(SpheresTest, AColumnThatIsDeclaredLateHasAllRows)
{
    spheres.add(point(), 1, 0);
    spheres.add(point(), 1, 0);
    {
        const RunningColumn<double> ids(spheres.running(), [&](std::uint32_t row, double& value)
                                        { value = 10.0 + spheres.running().id[row]; });
        EXPECT_EQ(ids[0], 10);
        EXPECT_EQ(ids[1], 11);
    }
    spheres.add(point(), 1, 0); // the column is gone
    EXPECT_EQ(spheres.running().size(), 3u);
}

TEST_F(SpheresTest, OneThatBeginsAnewIsWhereItIsPutWithoutSpeed)
{
    add();
    note(0, "old");
    spheres.running().restart(0, {1, 2, 3});
    EXPECT_EQ(spheres.position(0), Vector3d(1, 2, 3));
    EXPECT_EQ(spheres.velocity(0), kStill);
    EXPECT_EQ(notes[0], "new");
}

// A search meets those of a cell in this order, and results depend on it.
TEST_F(SpheresTest, OneThatIsRenumberedIsMetFirstInItsCell)
{
    const Vector3d place(1, 1, 1);
    const std::uint32_t runs = spheres.add(place, 1, 0);
    const std::uint32_t below = spheres.addResting(place, 1, 0);
    const std::uint32_t last = spheres.addResting(place, 1, 0);
    const auto order = [&]
    {
        std::vector<std::uint32_t> ids;
        spheres.resting().forEachNear(
            place, 0.1, [&](std::uint32_t row) { ids.push_back(spheres.resting().id(row)); });
        return ids;
    };
    spheres.addResting(place, 1, 0);
    spheres.wake(below);
    EXPECT_EQ(order(), (std::vector<std::uint32_t>{3, last})) << "that of the others stays";
    spheres.freeze(below);
    EXPECT_EQ(order(), (std::vector<std::uint32_t>{below, 3, last}));
    EXPECT_EQ(spheres.withdraw(runs), 3u);
    EXPECT_EQ(order(), (std::vector<std::uint32_t>{runs, below, last}));
}

} // namespace
} // namespace frostfill
