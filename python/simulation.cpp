// SPDX-License-Identifier: MIT
#include "simulation.hpp"

#include "input.hpp"
#include "interrupts.hpp"
#include "pictures.hpp"
#include "reports.hpp"
#include "state.hpp"

#include <frostfill/picture_settings.hpp>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <functional>
#include <limits>
#include <memory>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

/// A simulation, its mesh, and the memory of its snapshots.
class Stepper
{
public:
    Stepper(const GivenMesh& given, const Scene& scene)
        : scene_(scene),
          mesh_(std::make_shared<const TriangleMesh>(given.load(scene.object.load).mesh)),
          simulation_(scene, *mesh_)
    {
    }

    bool step()
    {
        const ExclusiveUse busy(busy_);
        const py::gil_scoped_release release;
        return simulation_.step();
    }

    /// Steps at most so often, and returns how often.
    std::uint64_t advance(std::int64_t most)
    {
        if (most < 0)
        {
            throw Error(ErrorCode::usage,
                        fmt::format("steps is {}, but it must be at least 0", most));
        }
        const ExclusiveUse busy(busy_);
        Interrupts interrupts;
        const std::uint64_t before = simulation_.steps();
        {
            const py::gil_scoped_release release;
            for (std::int64_t i = 0; i < most && !interrupts.happened() && simulation_.step(); ++i)
            {
            }
        }
        interrupts.throwIfHappened();
        return simulation_.steps() - before;
    }

    std::shared_ptr<State> snapshot()
    {
        const ExclusiveUse busy(busy_);
        const std::shared_ptr<State> state = freeState();
        const py::gil_scoped_release release;
        capture(*state);
        return state;
    }

    /// The state after one more step.
    std::shared_ptr<State> next()
    {
        if (simulation_.finished())
        {
            throw py::stop_iteration();
        }
        const ExclusiveUse busy(busy_);
        const std::shared_ptr<State> state = freeState();
        const py::gil_scoped_release release;
        simulation_.step();
        capture(*state);
        return state;
    }

    py::array render(const py::kwargs& keywords)
    {
        Scene scene = scene_;
        GivenKeywords(keywords, OptionUse::pictures, "Simulation.render").apply(scene);
        validateScene(scene);
        const std::shared_ptr<State> state = snapshot();
        const ExclusiveUse busy(busy_);
        return drawPicture(*mesh_, pictureSettings(simulation_, scene), state->snapshot);
    }

    /// What changes nothing and takes no time.
    template <class Get>
    auto ask(Get get)
    {
        const ExclusiveUse busy(busy_);
        return std::invoke(get, simulation_);
    }
    template <class Get>
    auto askSlowly(Get get)
    {
        const ExclusiveUse busy(busy_);
        const py::gil_scoped_release release;
        return std::invoke(get, simulation_);
    }

    [[nodiscard]] const std::shared_ptr<const TriangleMesh>& mesh() const { return mesh_; }
    [[nodiscard]] const Scene& scene() const { return scene_; }

private:
    /// One that nobody has any more. Two take turns: while a caller looks at the newest state the
    /// next one goes into the other, and each is brought up to date at the cost of what has
    /// changed.
    std::shared_ptr<State> freeState()
    {
        for (std::shared_ptr<State>& state : states_)
        {
            if (state && state.use_count() == 1)
            {
                return state;
            }
        }
        std::shared_ptr<State>& oldest = states_[turn_];
        turn_ = 1 - turn_;
        oldest = std::make_shared<State>();
        oldest->snapshot.columns = carriedColumns(askedColumns(scene_));
        return oldest;
    }

    void capture(State& state)
    {
        simulation_.capture(state.snapshot);
        state.centres.resize(state.snapshot.states.size());
        state.radii.resize(state.snapshot.states.size());
        for (const std::uint32_t id : state.snapshot.changed)
        {
            const SphereRecord sphere = simulation_.sphere(id);
            state.centres[id] = sphere.centre;
            state.radii[id] = sphere.radius;
        }
    }

    Scene scene_;
    std::shared_ptr<const TriangleMesh> mesh_;
    Simulation simulation_;
    std::array<std::shared_ptr<State>, 2> states_;
    std::size_t turn_ = 0;
    std::atomic<bool> busy_ = false;
};

std::unique_ptr<Stepper> makeStepper(const py::object& mesh, const py::object& vertices,
                                     const py::object& triangles, const py::kwargs& keywords)
{
    const GivenKeywords given(keywords, OptionUse::filling, "Simulation");
    const GivenMesh object = readGivenMesh(mesh, vertices, triangles);
    const Scene scene = given.sceneFor(object.name);
    validateScene(scene);
    given.warnOfIgnored(scene.preset);
    const py::gil_scoped_release release;
    return std::make_unique<Stepper>(object, scene);
}

void addSteps(py::class_<Stepper>& simulation)
{
    simulation
        .def("step", &Stepper::step,
             "Advances by one time step. Returns False when the run is over.")
        .def(
            "advance",
            [](Stepper& s, const py::object& steps)
            {
                return s.advance(steps.is_none() ? std::numeric_limits<std::int64_t>::max()
                                                 : wholeNumberOf(steps, "steps"));
            },
            py::arg("steps") = py::none(),
            "Takes this many steps, or all to the end, without returning to Python in between. "
            "Returns how many were taken. Ctrl-C stops it after a step.")
        .def("snapshot", &Stepper::snapshot, "The state as it is now: a Snapshot.")
        .def("__iter__", [](py::object self) { return self; })
        .def("__next__", &Stepper::next)
        .def("render", &Stepper::render,
             "Draws the state as it is now: uint8 [height, width, 3 or 4]. Takes the keywords of "
             "frostfill.Run.render but frame.")
        .def(
            "state_hash", [](Stepper& s) { return s.ask(&Simulation::stateHash); },
            "Hash of the bits of all positions, and of which spheres are at rest: 16 hex digits.")
        .def(
            "quality", [](Stepper& s) { return s.askSlowly(&Simulation::quality); },
            "Judges the state as it is now: a QualityReport.");
}

void addFacts(py::class_<Stepper>& simulation)
{
    const auto fact = [&](const char* name, auto get, const char* help)
    {
        simulation.def_property_readonly(
            name, [get](Stepper& s) { return s.ask(get); }, help);
    };
    fact(
        "finished", [](const Simulation& s) { return s.finished(); }, "The run is over.");
    fact(
        "full", [](const Simulation& s) { return s.full(); },
        "The run is over because no sphere fits any more.");
    fact(
        "inlets_reached", [](const Simulation& s) { return s.inletsReached(); },
        "The run is over because no sphere comes through the inlets any more.");
    fact(
        "time", [](const Simulation& s) { return s.time(); }, "Simulated time, in seconds.");
    fact(
        "time_step", [](const Simulation& s) { return s.timeStep(); }, "In seconds.");
    fact(
        "steps", [](const Simulation& s) { return s.steps(); }, "Number of steps so far.");
    fact(
        "radius", [](const Simulation& s) { return s.radius(); },
        "The largest radius of the run, in the unit of the mesh.");
    fact(
        "smallest_radius", [](const Simulation& s) { return s.smallestRadius(); },
        "The smallest radius of the run, in the unit of the mesh.");
    fact(
        "sizes", [](const Simulation& s) { return s.sizes(); },
        "The size curve so far beside the one of the keyword sizes; None without that.");
    fact(
        "sphere_count", [](const Simulation& s) { return s.sphereCount(); },
        "Spheres that have appeared.");
    fact(
        "resting_count", [](const Simulation& s) { return s.restingCount(); },
        "Spheres at rest: frozen and discarded.");
    fact(
        "expected_spheres", [](const Simulation& s) { return s.expectedSpheres(); },
        "The target of the run: the count, or an estimate if it fills until full.");
    fact(
        "stray",
        [](const Simulation& s)
        { return s.stray() ? std::optional(s.stray()->sphere) : std::nullopt; },
        "The sphere that stopped the run, because no sphere can be where it is; None if there is "
        "none.");
    simulation
        .def_property_readonly(
            "vertices", [](const Stepper& s) { return view(s.mesh(), s.mesh()->vertices); },
            "float64 [v, 3]: of the mesh as simulated, after repair.")
        .def_property_readonly(
            "triangles",
            [](const Stepper& s)
            {
                const auto& triangles = s.mesh()->triangles;
                return view(s.mesh(), reinterpret_cast<const std::uint32_t*>(triangles.data()),
                            {static_cast<py::ssize_t>(triangles.size()), 3});
            },
            "uint32 [t, 3]: indices into vertices, counter-clockwise seen from outside.")
        .def_property_readonly(
            "options", [](const Stepper& s) { return keywordsOfScene(s.scene()); },
            "All settings of the run, by keyword.")
        .def("__repr__",
             [](Stepper& s)
             {
                 return s.ask(
                     [&](const Simulation& simulated)
                     {
                         return fmt::format("<frostfill.Simulation of {}: {} spheres, {} at rest, "
                                            "{:.6g} s>",
                                            s.scene().name, simulated.sphereCount(),
                                            simulated.restingCount(), simulated.time());
                     });
             });
}

} // namespace

void addSimulation(py::module_& module)
{
    py::class_<Stepper> simulation(module, "Simulation", py::dynamic_attr(),
                                   R"(A run, step by step. Nothing is written.

Iterating over it takes a step and gives the state after it, a Snapshot, until the run is over. The
keywords are those of frostfill.fill.)");
    simulation.def(py::init(&makeStepper), py::arg("mesh") = py::none(), py::kw_only(),
                   py::arg("vertices") = py::none(), py::arg("triangles") = py::none());
    addSteps(simulation);
    addFacts(simulation);
}

} // namespace frostfill::python
