// SPDX-License-Identifier: MIT
// The table of docs/options.md against the table of options.
#include "support/paths.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/options.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace frostfill
{
namespace
{

const std::string kBegin = "<!-- written by the test OptionsPage -->\n";
const std::string kEnd = "<!-- end of what is written -->\n";

/// A heading for each group, and a row for each key.
std::string tableOfOptions()
{
    const Scene standard = presetScene(Preset::fast, "torus");
    std::string text = "| key | flag | values | default | meaning |\n|---|---|---|---|---|\n";
    std::string group;
    for (const Option& option : sceneOptions())
    {
        text += option.group == group ? "" : fmt::format("| **{}** | | | | |\n", option.group);
        group = option.group;
        const std::string preset = !option.preset                   ? ""
                                   : *option.preset == Preset::fast ? " (preset fast)"
                                                                    : " (preset paper)";
        text += fmt::format("| `{}` | {} | {} | {} | {}{} |\n", option.key,
                            option.flag.empty() ? "" : fmt::format("`{}`", option.flag),
                            describeAllowed(option), optionText(option, option.get(standard)),
                            option.help, preset);
    }
    return text;
}

TEST(OptionsPage, HasEveryKeyOfTheScene)
{
    const std::filesystem::path file = testing_support::sourceFolder() / "docs/options.md";
    const std::string page = test::readFile(file);
    const std::size_t begin = page.find(kBegin);
    const std::size_t end = page.find(kEnd);
    ASSERT_NE(begin, std::string::npos);
    ASSERT_NE(end, std::string::npos);
    const std::string wanted = page.substr(0, begin) + kBegin + tableOfOptions() + page.substr(end);
    if (std::getenv("FROSTFILL_WRITE_PAGES") != nullptr)
    {
        test::writeFile(file, wanted);
    }
    EXPECT_TRUE(test::readFile(file) == wanted)
        << "write it again: FROSTFILL_WRITE_PAGES=1 and this test";
    EXPECT_LE(std::count(page.begin(), page.end(), '\n'), 150);
}

} // namespace
} // namespace frostfill
