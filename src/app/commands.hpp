// SPDX-License-Identifier: MIT
// Room: the command line: parse, call, report. It decides nothing about a run.
#pragma once

#include <CLI/App.hpp>

#include <functional>

namespace frostfill
{

/// Does the work of a command and returns the program's exit code. Throws Error.
using Command = std::function<int()>;

/// Each function adds a command to the program and returns the function that runs it.
Command addAnalyseCommand(CLI::App& program);
Command addBenchCommand(CLI::App& program);
Command addCheckCommand(CLI::App& program);
Command addExportCommand(CLI::App& program);
Command addFiguresCommand(CLI::App& program);
Command addFillCommand(CLI::App& program);
Command addFpsCommand(CLI::App& program);
Command addImportCommand(CLI::App& program);
Command addMeshCommand(CLI::App& program);
Command addDoctorCommand(CLI::App& program);
Command addRenderCommand(CLI::App& program);
Command addSweepCommand(CLI::App& program);
Command addViewCommand(CLI::App& program);
Command addOptionsCommand(CLI::App& program);
Command addHelpCommand(CLI::App& program);
Command addVersionCommand(CLI::App& program);
Command addCompletionCommand(CLI::App& program);

} // namespace frostfill
