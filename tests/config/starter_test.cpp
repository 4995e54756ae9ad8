// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/starter.hpp"

#include "corticle/config/case_file.hpp"

#include <gtest/gtest.h>

namespace corticle
{

namespace
{

void replace(std::string& text, const std::string& old, const std::string& with)
{
    const std::size_t at = text.find("\n" + old);
    ASSERT_NE(at, std::string::npos) << old;
    text.replace(at + 1, old.size(), with);
}

config::Options parsed(const std::string& text)
{
    return config::parse_case(text, "starter", {}, "");
}

} // namespace

// What stands behind a comment sign in a starter is valid without it.

TEST(Starter, ItsResolutionsAreValid)
{
    for (const char* key : {"spacing_mm", "elements"})
    {
        std::string text = config::starter_case(prepare::Shape::sphere);
        replace(text, "particles = ", "# particles = ");
        replace(text, "# " + std::string(key) + " = ", std::string(key) + " = ");
        EXPECT_NO_THROW(parsed(text)) << key;
        replace(text, "method = \"tlsph\"", "method = \"fem\"");
        EXPECT_NO_THROW(parsed(text)) << key << " with finite elements";
    }
}

TEST(Starter, ItsWeeksAreValid)
{
    for (const char* clock : {"wang", "cubic"})
    {
        std::string text = config::starter_case(prepare::Shape::ellipsoid);
        replace(text, "clock = \"none\"", "clock = \"" + std::string(clock) + "\"");
        replace(text, "start = ", "# start = ");
        replace(text, "end = ", "# end = ");
        replace(text, "# start_week = ", "start_week = ");
        replace(text, "# end_week = ", "end_week = ");
        EXPECT_NO_THROW(parsed(text)) << clock;
    }
}

TEST(Starter, WeeksTakenOutOfTheirCommentsEverywhereAreThoseOfTheRun)
{
    std::string text = config::starter_case(prepare::Shape::sphere);
    replace(text, "clock = \"none\"", "clock = \"wang\"");
    replace(text, "start = ", "# start = ");
    replace(text, "end = ", "# end = ");
    for (const std::string key : {"start_week", "end_week"}) // as an editor does: every line that begins so
    {
        for (std::size_t at = 0; (at = text.find("\n# " + key + " =", at)) != std::string::npos;)
        {
            text.erase(at + 1, 2);
        }
    }
    EXPECT_EQ(parsed(text).time.start_week, 23.0);
}

TEST(Starter, ATableOfAListIsValidOnceItIsNoComment)
{
    std::string text = config::starter_case(prepare::Shape::sphere);
    replace(text, "# [[support]]", "[[support]]");
    replace(text, "#   kind = ", "  kind = ");
    replace(text, "#   plane = ", "  plane = ");
    EXPECT_EQ(parsed(text).supports.size(), 1U);
}

} // namespace corticle
