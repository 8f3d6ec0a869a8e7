// SPDX-License-Identifier: MIT
// What Python cannot do itself, over the public headers. Python's side is frostfill/__init__.py.
#include "analysis.hpp"
#include "errors.hpp"
#include "instruments.hpp"
#include "keywords.hpp"
#include "pictures.hpp"
#include "reports.hpp"
#include "run.hpp"
#include "simulation.hpp"
#include "state.hpp"

#include <frostfill/measure.hpp>

#include <pybind11/pybind11.h>

PYBIND11_MODULE(_frostfill, module)
{
    using namespace frostfill::python;
    module.attr("version") = frostfill::describeMachine().version;
    addErrors(module);
    addKeywords(module);
    addState(module);
    addReports(module);
    addSimulation(module);
    addRun(module);
    addPictures(module);
    addInstruments(module);
    addAnalysis(module);
}
