// SPDX-License-Identifier: MIT
// Calls with faults, from a table that the tests of Python read, too: each ends with one line that
// says what is wrong, and what was there before is there afterwards, to the last bit.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

struct WrongCall
{
    std::size_t line = 0; ///< of the table
    int code = 0;
    std::string says;
    std::string arguments;
    std::string content; ///< of FILE
};

/// With \n, \0 and \xHH for what no line can have.
std::string unescaped(const std::string& text)
{
    std::string bytes;
    for (std::size_t at = 0; at < text.size(); ++at)
    {
        if (text[at] != '\\')
        {
            bytes += text[at];
            continue;
        }
        const char what = text[++at];
        if (what == 'x')
        {
            bytes += static_cast<char>(std::stoi(text.substr(at + 1, 2), nullptr, 16));
            at += 2;
        }
        else
        {
            bytes += what == 'n' ? '\n' : '\0';
        }
    }
    return bytes;
}

std::vector<WrongCall> tableOfCalls()
{
    std::ifstream table(FROSTFILL_WRONG_CALLS);
    std::vector<WrongCall> calls;
    std::size_t number = 0;
    for (std::string line; std::getline(table, line);)
    {
        ++number;
        if (line.empty() || line.front() == '#')
        {
            continue;
        }
        std::vector<std::string> parts;
        for (std::size_t at = 0; parts.size() < 3; at += parts.back().size() + 3)
        {
            parts.push_back(line.substr(at, line.find(" | ", at) - at));
            if (parts.size() == 3)
            {
                const std::size_t rest = at + parts.back().size() + 3;
                parts.push_back(rest < line.size() ? line.substr(rest) : "");
            }
        }
        if (parts[2].ends_with(" |")) // nothing is in the file
        {
            parts[2].resize(parts[2].size() - 2);
        }
        calls.push_back({number, std::stoi(parts[0]), parts[1], parts[2], unescaped(parts[3])});
    }
    return calls;
}

/// What is in each file of a folder.
std::map<std::string, std::string> contentOf(const std::filesystem::path& folder)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
        const std::string name = entry.path().lexically_relative(folder).string();
        if (!name.starts_with("answer."))
        {
            files[name] = entry.is_directory() ? "" : test::readFile(entry.path());
        }
    }
    return files;
}

void replaceAll(std::string& text, const std::string& what, const std::string& by)
{
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    {
        text.replace(at, what.size(), by);
    }
}

TEST(WrongCalls, EachEndWithOneLineAndLoseNothing)
{
    const test::TemporaryFolder folder;
    const auto run = [&](const std::string& arguments)
    { return test::runProgram(arguments, folder.path()); };
    ASSERT_EQ(run("fill cube --count 5 --motion descend --frames last --quiet --out run").code, 0);
    ASSERT_EQ(run("export run --to csv --quiet").code, 0);
    ASSERT_EQ(run("export run --to csv --out export --quiet").code, 0);
    ASSERT_EQ(run("analyse run --out analysis --only contacts --quiet").code, 0);
    std::filesystem::create_directory(folder / "folder");
    const std::vector<WrongCall> calls = tableOfCalls();
    EXPECT_GE(calls.size(), 130U);
    for (const WrongCall& call : calls)
    {
        test::writeFile(folder / "input.csv", call.content);
        const auto before = contentOf(folder.path());
        std::string arguments = call.arguments;
        replaceAll(arguments, "FILE", "input.csv");
        replaceAll(arguments, "fill cube",
                   "fill cube --count 5 --frames none --out run --overwrite");
        const test::Answer answer = run(arguments);
        const std::string where =
            fmt::format("line {} of the table, {}: {}", call.line, arguments, answer.errors);
        EXPECT_EQ(answer.code, call.code) << where;
        EXPECT_NE(answer.errors.find(call.says), std::string::npos) << where;
        const bool warns = answer.errors.starts_with("frostfill: warning: ");
        EXPECT_EQ(std::count(answer.errors.begin(), answer.errors.end(), '\n'), warns ? 2 : 1)
            << where;
        EXPECT_EQ(contentOf(folder.path()), before) << where;
    }
}

} // namespace
} // namespace frostfill
