// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/large_allocations.hpp"
#include "app/progress/message.hpp"
#include "app/scene_options.hpp"

#include <frostfill/failure.hpp>
#include <frostfill/options.hpp>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <memory>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace
{

using namespace frostfill;

constexpr const char* kUsage = R"(Examples:
  frostfill fill torus                    the paper's torus: frames and tables in output/torus
  frostfill fill bunny.stl --radius 0.02  any closed mesh, until it is full
  frostfill render output/torus --azimuth 60 --style dark   draw a kept run again
  frostfill view output/torus             a page for any browser
  frostfill fps                           frames per second, the paper's and ours
  frostfill mesh bunny.stl                inspect a mesh
  frostfill check packing.csv --mesh part.stl   judge a packing from any program
  frostfill analyse output/torus          porosity, neighbours, contacts, cells, order
  frostfill COMMAND --help                all options of a command
)";

/// The help of CLI11, without the "{false}" after the negative form of a flag.
class HelpFormatter : public CLI::Formatter
{
public:
    HelpFormatter() { column_width(32); }

    std::string make_option_name(const CLI::Option* option, bool positional) const override
    {
        std::string name = CLI::Formatter::make_option_name(option, positional);
        const std::size_t mark = name.find("{false}");
        return mark == std::string::npos ? name : name.erase(mark, 7);
    }
};

int report(int code, const std::string& message)
{
    say(fmt::format("frostfill: {}\n", message));
    return code;
}

/// The option that was probably intended, as the end of a sentence.
std::string didYouMean(const CLI::App& program, const std::string& argument)
{
    std::vector<std::string> known;
    for (const CLI::App* command : program.get_subcommands())
    {
        for (const CLI::Option* option : command->get_options())
        {
            for (const std::string& name : option->get_lnames())
            {
                known.push_back("--" + name);
            }
        }
    }
    const std::string nearest = nearestName(argument.substr(0, argument.find('=')), known);
    return nearest.empty() ? "" : "; did you mean " + nearest + "?";
}

/// The first word, where a command should stand and does not; empty if there is none.
std::string wrongCommand(const CLI::App& program, const std::vector<std::string>& words)
{
    const CLI::App* at = &program;
    for (const std::string& word : words)
    {
        const auto commands = at->get_subcommands(nullptr);
        const auto found =
            std::find_if(commands.begin(), commands.end(),
                         [&](const CLI::App* each) { return each->get_name() == word; });
        if (found == commands.end())
        {
            return commands.empty() || word.starts_with('-') ? "" : word;
        }
        at = *found;
    }
    return "";
}

/// The commands that could stand in place of the wrong one.
std::vector<std::string> commandsLike(const CLI::App& program, const std::string& first)
{
    const CLI::App* at = &program;
    for (const CLI::App* command : program.get_subcommands(nullptr))
    {
        at = command->get_name() == first ? command : at;
    }
    std::vector<std::string> names;
    for (const CLI::App* command : at->get_subcommands(nullptr))
    {
        names.push_back(command->get_name());
    }
    return names;
}

int reportParseError(const CLI::App& program, const CLI::ParseError& error,
                     const std::vector<std::string>& words)
{
    // CLI11 also reports help and version as exceptions.
    if (error.get_exit_code() == 0)
    {
        return program.exit(error);
    }
    constexpr int kUsageError = static_cast<int>(ErrorCode::usage);
    if (const std::string wrong = wrongCommand(program, words);
        !wrong.empty() && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    {
        const std::string nearest = nearestName(wrong, commandsLike(program, words.front()));
        return report(kUsageError,
                      fmt::format("no command '{}'{}", wrong,
                                  nearest.empty() ? "; see frostfill --help"
                                                  : fmt::format("; did you mean {}?", nearest)));
    }
    if (dynamic_cast<const CLI::ExtrasError*>(&error))
    {
        for (const CLI::App* command : program.get_subcommands())
        {
            for (const std::string& rest : command->remaining())
            {
                return report(kUsageError, fmt::format("unexpected argument '{}'{}", rest,
                                                       didYouMean(program, rest)));
            }
        }
    }
    const std::string what = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr &&
        what.find(": At Most 1 required") != std::string::npos)
    {
        return report(kUsageError, fmt::format("{} is given more than once: give it once",
                                               what.substr(0, what.find(':'))));
    }
    return report(kUsageError, fmt::format("{}; see frostfill --help", what));
}

/// No option takes an empty text: a folder without a name would be the usual one, in silence.
void requireValues(const CLI::App& command)
{
    for (const CLI::Option* option : command.get_options())
    {
        const auto& values = option->results();
        if (std::find(values.begin(), values.end(), "") != values.end())
        {
            throw Error(ErrorCode::usage, fmt::format("{} is '', but it must not be empty",
                                                      option->get_name(option->get_positional())));
        }
    }
    for (const CLI::App* inner : command.get_subcommands())
    {
        requireValues(*inner);
    }
}

/// What could not be printed is a failed write. If the reader of a pipe has gone away, the program
/// ends as others do: by SIGPIPE, without a word.
int reportUnprinted()
{
    pollfd output = {STDOUT_FILENO, 0, 0};
    if (poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0)
    {
        std::signal(SIGPIPE, SIG_DFL);
        std::raise(SIGPIPE);
    }
    return report(static_cast<int>(ErrorCode::writeFailed), "cannot write to standard output");
}

struct NamedCommand
{
    const char* name;
    Command (*add)(CLI::App& program);
    bool needsOthers = false; ///< it tells of them
};
constexpr NamedCommand kCommands[] = {
    {"fill", addFillCommand},
    {"render", addRenderCommand},
    {"view", addViewCommand},
    {"sweep", addSweepCommand},
    {"fps", addFpsCommand},
    {"bench", addBenchCommand},
    {"check", addCheckCommand},
    {"analyse", addAnalyseCommand},
    {"figures", addFiguresCommand},
    {"export", addExportCommand},
    {"import", addImportCommand},
    {"mesh", addMeshCommand},
    {"doctor", addDoctorCommand},
    {"options", addOptionsCommand, true},
    {"help", addHelpCommand, true},
    {"version", addVersionCommand},
    {"completion", addCompletionCommand, true},
};

/// Adds the command that the first word names, or all: to describe the options of all of them takes
/// longer than to start the program.
std::vector<std::pair<std::string, Command>> addCommands(CLI::App& program,
                                                         const std::string& first)
{
    const auto named = std::find_if(std::begin(kCommands), std::end(kCommands),
                                    [&](const NamedCommand& each) { return each.name == first; });
    const bool isEnough = named != std::end(kCommands) && !named->needsOthers;
    std::vector<std::pair<std::string, Command>> added;
    for (const NamedCommand& each : kCommands)
    {
        if (!isEnough || each.name == first)
        {
            added.emplace_back(each.name, each.add(program));
        }
    }
    return added;
}

int run(int argumentCount, char** arguments)
{
    CLI::App program("Fills a closed mesh with falling spheres and renders it without a screen.",
                     "frostfill");
    program.set_version_flag("--version", std::string("frostfill ") + FROSTFILL_VERSION);
    program.footer(kUsage);
    program.formatter(std::make_shared<HelpFormatter>());
    program.require_subcommand(1);

    const std::vector<std::string> words = withImpliedValues(argumentCount, arguments);
    const auto commands = addCommands(program, words.empty() ? "" : words.front());
    try
    {
        program.parse(
            std::vector<std::string>(words.rbegin(), words.rend())); // as CLI11 wants them
    }
    catch (const CLI::ParseError& error)
    {
        return reportParseError(program, error, words);
    }
    requireValues(program);
    for (const auto& [name, command] : commands)
    {
        if (program.got_subcommand(name))
        {
            return command();
        }
    }
    return 0;
}

/// Tells Mesa where to keep compiled shaders, which take most of the time before a first picture.
/// The folder is our own, in the user's cache: Mesa complains on standard error when another
/// program removes files of a shared one. What the environment says stands. Without such a folder
/// nothing is kept. Only a program may change its environment, and only before it has threads.
void chooseShaderCache()
{
    if (std::getenv("MESA_SHADER_CACHE_DISABLE") != nullptr ||
        std::getenv("MESA_SHADER_CACHE_DIR") != nullptr)
    {
        return;
    }
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    std::filesystem::path folder = cache != nullptr && *cache == '/' ? std::filesystem::path(cache)
                                   : home != nullptr && *home == '/'
                                       ? std::filesystem::path(home) / ".cache"
                                       : std::filesystem::path();
    std::error_code none;
    std::filesystem::path there = folder /= "frostfill";
    while (there.has_relative_path() && !std::filesystem::exists(there, none))
    {
        there = there.parent_path();
    }
    const bool isUsable = folder.is_absolute() && std::filesystem::is_directory(there, none) &&
                          access(there.c_str(), W_OK | X_OK) == 0;
    setenv(isUsable ? "MESA_SHADER_CACHE_DIR" : "MESA_SHADER_CACHE_DISABLE",
           isUsable ? folder.c_str() : "true", 1);
}

/// A standard stream that was closed would give its number to the next file that is opened, and
/// what is printed would end up in that. Each gets a file that fails: it cannot be read or written.
void occupyClosedStreams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    {
        if (fcntl(stream, F_GETFD) < 0)
        {
            std::ignore = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

} // namespace

int main(int argumentCount, char** arguments)
{
    useMemoryAgain();
    occupyClosedStreams();
    // A reader that has gone away and a limit on the size of files are failed writes, and no reason
    // to lose a run, or to end by the pipe to another program.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    try
    {
        chooseShaderCache();
        const int code = run(argumentCount, arguments);
        // Standard output can be a file on a full disk.
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        {
            return reportUnprinted();
        }
        return code;
    }
    catch (...)
    {
        const Failure failure = currentFailure();
        // fmt may have failed to print.
        if (failure.code == ErrorCode::writeFailed &&
            (std::fflush(stdout) != 0 || std::ferror(stdout) != 0))
        {
            return reportUnprinted();
        }
        return report(static_cast<int>(failure.code), failure.message);
    }
}
