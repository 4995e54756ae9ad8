// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/label_table.hpp"

#include "corticle/base/error.hpp"
#include "formats/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace corticle
{

namespace
{

formats::LabelTable read(std::string_view text)
{
    const TemporaryFolder folder;
    put_bytes(folder / "table.csv", text);
    constexpr std::array<std::string_view, 3> used{"growth", "onset", "rate"};
    return formats::read_label_table(folder / "table.csv", used);
}

std::string refusal(std::string_view text)
{
    return message_of<InputError>([&] { read(text); });
}

} // namespace

TEST(LabelTable, ColumnsInAnyOrder)
{
    const formats::LabelTable table = read("# lobes\ngrowth, label ,onset\n1.5, 2, 0.1\r\n\n0.5,-7,0.25\n");
    EXPECT_EQ(table.columns, (std::vector<std::string>{"growth", "onset"}));
    EXPECT_EQ(table.rows.at(2), (std::vector<double>{1.5, 0.1}));
    EXPECT_EQ(table.rows.at(-7), (std::vector<double>{0.5, 0.25}));
    EXPECT_EQ(table.column("onset"), 1);
    EXPECT_EQ(table.column("rate"), -1);
}

TEST(LabelTable, RefusesInOneLine)
{
    EXPECT_NE(refusal("1,2\n").find(":1: no header"), std::string::npos);
    EXPECT_NE(refusal("label\n1\n").find("no header"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n").find("no rows"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n1\n").find("line 2: wrong number of cells; got 1; expected 2"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n1,x\n").find("bad value; got x"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n1,nan\n").find("bad value"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n1.5,1\n").find("bad label"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n1,1\n1,2\n").find(":3: label given twice"), std::string::npos);
}

TEST(LabelTable, LeavesOtherColumnsAlone)
{
    const formats::LabelTable table = read("label;name;growth;groth\n1;frontal;1,2;x\n2;\"parietal; upper\";1;\n");
    EXPECT_EQ(table.columns, std::vector<std::string>{"growth"});
    EXPECT_EQ(table.unused, (std::vector<std::string>{"name", "groth"}));
    EXPECT_EQ(table.rows.at(1), std::vector<double>{1.2});
    EXPECT_EQ(table.rows.at(2), std::vector<double>{1.0});
    EXPECT_NE(refusal("label,name,growth\n1,frontal,high\n").find(":2: bad value; got high"), std::string::npos);
    EXPECT_NE(refusal("label,growth,growth\n1,1,2\n").find("a column given twice; got growth"), std::string::npos);
    EXPECT_NE(refusal("label,name,growth\n1,frontal, left,1\n").find("got 4; expected 3"), std::string::npos);
}

} // namespace corticle
