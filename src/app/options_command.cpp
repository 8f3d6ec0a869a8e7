// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/help/command_text.hpp"
#include "run/options_page.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>

namespace frostfill
{
namespace
{

constexpr const char* kStart = R"(# Options

`frostfill options` prints this page from the tables that also read the command line. The order of options does not matter.
Lengths in [mesh unit] are in the unit of the mesh file. r is the radius of the spheres and g is gravity.

## Scenes

The command `fill` takes all of these options, and `render` those of frames, picture and camera but `--slow-motion`, `--duration` and
`--keep-run`. A scene file (`--scene FILE.toml`) and `summary.json` use the keys.
The defaults are those of `frostfill fill torus`.
)";

constexpr const char* kEnd = R"(
## Exit codes

| code | meaning |
|---:|---|
| 0 | success |
| 2 | a comparison, a claim or a run of a sweep failed |
| 64 | wrong use of the command line |
| 65 | the mesh or the scene cannot be used, or the runs to be gathered are incomplete |
| 66 | an input file is missing |
| 69 | OpenGL or a required program is missing |
| 70 | the result is wrong: a sphere outside the mesh, an overlap, spheres without support, or a blank picture; the files are kept |
| 71 | out of memory |
| 73 | an output file or directory cannot be created |
| 74 | writing failed |
| 75 | stopped by a signal, all files are complete; or another process is still doing runs of the sweep |
)";

/// In a cell of a table a vertical bar would start the next cell.
std::string cell(const std::string& text)
{
    std::string escaped;
    for (const char letter : text)
    {
        if (letter == '|')
        {
            escaped.push_back('\\');
        }
        escaped.push_back(letter);
    }
    return escaped;
}

/// The option as the command line takes it: "--out DIR", or "MESH" for a positional one.
std::string usageOf(const OptionText& option)
{
    const std::string names = fmt::format("{}", fmt::join(option.names, ","));
    return option.value.empty() ? names : fmt::format("{} {}", names, option.value);
}

/// A row for each option of a command. The options of scenes, which fill and render have, have
/// tables of their own.
std::string rowsOf(const CommandText& command)
{
    std::string rows;
    for (const OptionText& option : command.options)
    {
        if (option.names.back() == "--help" ||
            ((command.name == "fill" || command.name == "render") &&
             isSceneOption(option.names.front())))
        {
            continue;
        }
        rows += fmt::format("| `{}` | {} |\n", cell(usageOf(option)), cell(option.help));
    }
    return rows;
}

} // namespace

Command addOptionsCommand(CLI::App& program)
{
    program.add_subcommand("options", "Print every option and its default as Markdown")
        ->footer("Examples:\n  frostfill options > options.md\n");
    return [&program]
    {
        std::string text = kStart + sceneOptionsMarkdown() + "\n## Commands\n";
        for (const CommandText& command : commandTexts(program))
        {
            if (const std::string rows = rowsOf(command); !rows.empty())
            {
                text += fmt::format("\n### frostfill {}\n\n| option | meaning |\n|---|---|\n{}",
                                    command.name, rows);
            }
        }
        fmt::print("{}{}", text, kEnd);
        return 0;
    };
}

} // namespace frostfill
