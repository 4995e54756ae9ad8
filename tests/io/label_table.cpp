// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/io/label_table.hpp"

#include "corticle/base/error.hpp"
#include "io/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace corticle
{

namespace
{

LabelTable read(std::string_view text)
{
    const TemporaryFolder folder;
    put_bytes(folder / "table.csv", text);
    return read_label_table(folder / "table.csv");
}

std::string refusal(std::string_view text)
{
    return message_of<InputError>([&] { read(text); });
}

} // namespace

TEST(LabelTable, ColumnsInAnyOrder)
{
    const LabelTable table = read("# lobes\ngrowth, label ,onset\n1.5, 2, 0.1\r\n\n0.5,-7,0.25\n");
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
    EXPECT_NE(refusal("label,growth\n1\n").find(":2: wrong number of fields; got 1; expected 2"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n1,x\n").find("bad value; got x"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n1,nan\n").find("bad value"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n1.5,1\n").find("bad label"), std::string::npos);
    EXPECT_NE(refusal("label,growth\n1,1\n1,2\n").find(":3: label given twice"), std::string::npos);
}

} // namespace corticle
