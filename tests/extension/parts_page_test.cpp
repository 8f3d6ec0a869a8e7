// SPDX-License-Identifier: MIT
// The code that docs/parts.md shows is the code of the files that it names, and those are built and
// run by parts_test.cpp.

#include "simulation/discard/discard_rule.hpp"
#include "simulation/freezing/freezing_rule.hpp"
#include "simulation/motion/integrator.hpp"
#include "simulation/paper/polygon_search.hpp"
#include "simulation/paper/sphere_search.hpp"
#include "simulation/release/release_rule.hpp"
#include "support/paths.hpp"

#include <frostfill/error.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace frostfill
{
namespace
{

std::string textOf(const std::filesystem::path& file)
{
    std::ifstream in(testing_support::sourceFolder() / file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

TEST(PageOfParts, ShowsTheCodeThatIsTested)
{
    const std::string page = textOf("docs/parts.md");
    static const std::regex kShown("`(tests/extension/add_[a-z_]+\\.cpp)`[^`]*```cpp\n([^`]*)```");
    std::set<std::string> shown;
    for (std::sregex_iterator it(page.begin(), page.end(), kShown), end; it != end; ++it)
    {
        const std::string file = (*it)[1];
        const std::string code = (*it)[2];
        EXPECT_GT(code.size(), 100u) << file;
        EXPECT_NE(textOf(file).find(code), std::string::npos)
            << file << " has no longer what docs/parts.md shows of it:\n"
            << code;
        shown.insert(file);
    }
    EXPECT_EQ(shown.size(), 6u);
}

TEST(NamesOfParts, AreTakenOnce)
{
    EXPECT_THROW((void)addPartName<Integrator>("explicit"), Error);
    EXPECT_THROW((void)addPartName<ReleaseRule>("column"), Error);
}

TEST(NamesOfParts, AreAsManyAsThereAreParts)
{
    EXPECT_EQ(integrators().size(), partNames<Integrator>().size());
    EXPECT_EQ(polygonSearches().size(), partNames<PolygonSearch>().size());
    EXPECT_EQ(sphereSearches().size(), partNames<SphereSearch>().size());
    EXPECT_EQ(discardRules().size(), partNames<DiscardRule>().size());
    EXPECT_EQ(freezingRules().size(), partNames<FreezingRule>().size());
    EXPECT_EQ(releaseRules().size(), partNames<ReleaseRule>().size());
}

} // namespace
} // namespace frostfill
