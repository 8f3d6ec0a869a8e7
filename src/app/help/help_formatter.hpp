// SPDX-License-Identifier: MIT
// Room: how the program and its commands are described: one line for each option.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace frostfill
{

/// The help of CLI11 with an option a line. --help-all adds the keys of the scene that a command
/// takes, and to the help of the program that of every command.
class HelpFormatter : public CLI::Formatter
{
public:
    /// `keysOf`: a line for each key that a command takes.
    explicit HelpFormatter(std::function<std::string(const CLI::App&)> keysOf);

    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override;
    std::string make_option(const CLI::Option* option, bool positional) const override;

private:
    std::function<std::string(const CLI::App&)> keysOf_;
};

} // namespace frostfill
