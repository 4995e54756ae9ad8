// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/number_table.hpp"

#include "corticle/base/error.hpp"
#include "corticle/study/markdown.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace corticle
{
namespace
{

const std::string sample = "t [-],area [mm2],week,work_growth [mu_w mm3]\n"
                           "0,1962.2437,23,0\n"
                           "0.5,  2.5e3 ,,-1e-3\n"
                           "1,+3,30.5,nan\n";

std::string message(const std::string& text)
{
    return message_of<InputError>([&] { formats::parse_number_table(text, "a.csv"); });
}

TEST(NumberTable, FindsColumnsByName)
{
    const formats::NumberTable table = formats::parse_number_table(sample, "a.csv");
    ASSERT_EQ(table.columns.size(), 4u);
    EXPECT_EQ(table.row_count(), 3u);
    ASSERT_NE(table.find("area"), nullptr);
    EXPECT_EQ(table.find("area")->unit, "mm2");
    EXPECT_EQ(table.find("area")->values, (std::vector<double>{1962.2437, 2500.0, 3.0}));
    EXPECT_EQ(table.find("work_growth")->unit, "mu_w mm3");
    EXPECT_EQ(table.find("week")->unit, "");
    EXPECT_TRUE(std::isnan(table.find("week")->values[1]));
    EXPECT_EQ(table.find("Area"), nullptr);
}

TEST(NumberTable, ReadsWindowsLinesAndNoRows)
{
    EXPECT_EQ(formats::parse_number_table("a,b\r\n1,2\r\n\r\n3,4", "a.csv").find("b")->values,
              (std::vector<double>{2, 4}));
    EXPECT_EQ(formats::parse_number_table("a,b\n", "a.csv").row_count(), 0u);
}

TEST(NumberTable, RefusesWhatIsNoTable)
{
    using testing::HasSubstr;
    EXPECT_THAT(message(""), HasSubstr("a.csv: not a table of numbers"));
    EXPECT_THAT(message("a,b\n1\n"), HasSubstr("line 2: wrong number of cells; got 1; expected 2"));
    EXPECT_THAT(message("a,b\n1,2\n1,2,3\n"), HasSubstr("line 3"));
    EXPECT_THAT(message("a,b\n1,two\n"), HasSubstr("line 2: bad number in column b; got two"));
    EXPECT_THAT(message("a,a\n1,2\n"), HasSubstr("bad header"));
    EXPECT_THAT(message("a,\n1,2\n"), HasSubstr("bad header"));
    EXPECT_THAT(message("0,1\n2,3\n"), HasSubstr("bad header"));
    EXPECT_THAT(message_of<InputError>([] { formats::read_number_table("no_such.csv"); }), HasSubstr("no_such.csv"));
}

TEST(NumberTable, JudgesTheColumnsThatAreUsed)
{
    const std::array<std::string_view, 2> used{"x", "y"};
    const formats::NumberTable table =
        formats::parse_number_table("name;x;y\nvertex;0,5;1\nfoot;2;-1,25\n", "a.csv", used);
    EXPECT_EQ(table.find("x")->values, (std::vector<double>{0.5, 2.0}));
    EXPECT_EQ(table.find("y")->values, (std::vector<double>{1.0, -1.25}));
    EXPECT_THAT(message("name,x\nvertex,1\n"), testing::HasSubstr("bad number in column name; got vertex"));
}

TEST(NumberTable, SurvivesDamage)
{
    std::mt19937 random(5);
    const auto below = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count)(random); };
    const std::string awkward = ",\n\r[]-+.e0\0 \"n";
    std::size_t refused = 0;
    for (int k = 0; k < 20000; ++k)
    {
        std::string text = sample;
        for (std::size_t change = 0; change <= below(4); ++change)
        {
            const std::size_t at = below(text.size());
            text.insert(at, 1, awkward[below(awkward.size() - 1)]);
            text.erase(below(text.size()), below(3));
        }
        try
        {
            const formats::NumberTable table = formats::parse_number_table(text, "a.csv");
            for (const formats::NumberColumn& column : table.columns)
            {
                ASSERT_EQ(column.values.size(), table.row_count());
            }
        }
        catch (const InputError& error)
        {
            ++refused;
            ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
    EXPECT_GT(refused, 1000u);
    EXPECT_LT(refused, 20000u);
}

TEST(Markdown, TableHasALineForEachRow)
{
    EXPECT_EQ(study::markdown_table({"a", "b"}, {{"1", "2"}, {"3", "4"}}),
              "| a | b |\n|---|---|\n| 1 | 2 |\n| 3 | 4 |\n\n");
}

TEST(Markdown, CellsAndNumbers)
{
    EXPECT_EQ(study::markdown_cell("a|b_c\n"), "a\\|b\\_c ");
    EXPECT_EQ(study::table_number(1.0 / 3.0), "0.33333");
    EXPECT_EQ(study::table_number(std::nan("")), "-");
    EXPECT_EQ(study::table_percent(12.345), "+12.3 %");
    EXPECT_EQ(study::table_percent(-0.5), "-0.5 %");
    EXPECT_EQ(study::table_percent(4e-14), "0 %");
    EXPECT_EQ(study::table_percent(std::nan("")), "-");
    EXPECT_EQ(study::table_difference(0.0123456), "+0.0123");
    EXPECT_EQ(study::table_difference(0.0), "0");
    EXPECT_EQ(study::table_difference(std::nan("")), "-");
}

} // namespace
} // namespace corticle
