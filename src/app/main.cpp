// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/help/help_formatter.hpp"
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
  frostfill render output/torus --out cover.png --style studio   draw a kept run again
  frostfill view output/torus             a page for any browser
  frostfill export output/torus --to vtp  a kept run for other programs
  frostfill check packing.csv --mesh part.stl    judge a packing from any program
  frostfill analyse output/torus          porosity, neighbours, contacts, cells, order
  frostfill COMMAND --help                the options of a command)";

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

int reportParseError(const CLI::App& program, const CLI::ParseError& error,
                     const std::vector<std::string>& words)
{
    // CLI11 also reports help and version as exceptions.
    if (error.get_exit_code() == 0)
    {
        return program.exit(error);
    }
    constexpr int kUsageError = static_cast<int>(ErrorCode::usage);
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands(nullptr))
    {
        names.push_back(command->get_name());
    }
    const std::string first = words.empty() ? "" : words.front();
    if (!first.empty() && !first.starts_with('-') &&
        std::find(names.begin(), names.end(), first) == names.end())
    {
        const std::string nearest = nearestName(first, names);
        return report(kUsageError,
                      fmt::format("no command '{}'{}", first,
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
};
constexpr NamedCommand kCommands[] = {
    {"fill", addFillCommand},       {"render", addRenderCommand}, {"view", addViewCommand},
    {"export", addExportCommand},   {"import", addImportCommand}, {"check", addCheckCommand},
    {"analyse", addAnalyseCommand}, {"mesh", addMeshCommand},     {"sweep", addSweepCommand},
    {"fps", addFpsCommand},         {"doctor", addDoctorCommand},
};

/// Adds what prints help, as the last of the options.
void addHelp(CLI::App& command)
{
    const std::vector<std::string> groups = command.get_groups();
    const std::string last = groups.back() == "Output" ? "Output" : "Options";
    command.set_help_flag("-h,--help", "Print this help")->group(last);
    command.set_help_all_flag("--help-all", "Print all: the keys of the scene, too")->group(last);
}

/// Adds the command that the first word names, or all: to describe the options of all of them takes
/// longer than to start the program.
std::vector<std::pair<std::string, Command>> addCommands(CLI::App& program,
                                                         const std::string& first)
{
    const bool isOne = std::any_of(std::begin(kCommands), std::end(kCommands),
                                   [&](const NamedCommand& each) { return each.name == first; });
    std::vector<std::pair<std::string, Command>> added;
    for (const NamedCommand& each : kCommands)
    {
        if (!isOne || each.name == first)
        {
            added.emplace_back(each.name, each.add(program));
            CLI::App* command = program.get_subcommand(each.name);
            addHelp(*command);
            command->group("Commands");
        }
    }
    program.add_subcommand("help", "Print the help of a command")->group("Commands");
    return added;
}

/// The words of the command line. "help fill" is "fill --help".
std::vector<std::string> wordsOf(int count, char** arguments)
{
    std::vector<std::string> words(arguments + std::min(count, 1), arguments + count);
    if (words.empty() || words.front() != "help")
    {
        return words;
    }
    words.erase(words.begin());
    const bool isKnown = words.empty() || std::any_of(std::begin(kCommands), std::end(kCommands),
                                                      [&](const NamedCommand& each)
                                                      { return each.name == words.front(); });
    if (isKnown)
    {
        words.emplace_back("--help");
    }
    return words;
}

bool hasOption(const CLI::App& command, const std::string& flag)
{
    const auto options = command.get_options();
    return std::any_of(options.begin(), options.end(),
                       [&](const CLI::Option* option) { return option->check_name(flag); });
}

/// Throws Error usage for a flag of earlier versions that the command does not have.
void refuseFormerFlags(const CLI::App& program, const std::vector<std::string>& words)
{
    for (const CLI::App* command : program.get_subcommands(nullptr))
    {
        for (std::size_t i = 1; command->get_name() == words.front() && i < words.size(); ++i)
        {
            const std::size_t equals = words[i].find('=');
            const std::string flag = words[i].substr(0, equals);
            const bool hasNext = i + 1 < words.size() && !words[i + 1].starts_with("--");
            const std::string value = equals != std::string::npos ? words[i].substr(equals + 1)
                                      : hasNext                   ? words[i + 1]
                                                                  : "";
            const bool isFlag = flag.starts_with("--") && command->get_subcommands(nullptr).empty();
            const std::string text =
                isFlag && !hasOption(*command, flag) ? formerFlagText(flag, value) : "";
            if (!text.empty())
            {
                throw Error(ErrorCode::usage, text);
            }
        }
    }
}

int run(int argumentCount, char** arguments)
{
    CLI::App program("Fills a closed mesh with falling spheres and renders it without a screen.",
                     "frostfill");
    program.set_version_flag("--version", std::string("frostfill ") + FROSTFILL_VERSION);
    addHelp(program);
    program.footer(kUsage);
    program.formatter(std::make_shared<HelpFormatter>(sceneKeysText));
    program.require_subcommand(1);

    const std::vector<std::string> words = wordsOf(argumentCount, arguments);
    const auto commands = addCommands(program, words.empty() ? "" : words.front());
    if (!words.empty())
    {
        refuseFormerFlags(program, words);
    }
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
