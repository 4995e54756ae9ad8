// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/vector_plot.hpp"

#include "corticle/base/error.hpp"
#include "corticle/view/vector_page.hpp"
#include "formats/surfaces/surface_samples.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace corticle
{

using ::testing::HasSubstr;
using ::testing::Not;

namespace
{

const std::vector<view::Panel> panels{
    {"gestational week", "area [mm²]", {{"run <1>", {23, 24, 25}, {1, 3, 2}}, {"real", {24}, {std::nan("")}, true}}},
    {"gestational week", "constant", {{"", {23, 24}, {5, 5}}}},
    {"gestational week", "nothing", {}}};

} // namespace

TEST(VectorPlot, SvgHoldsLinesAndLetters)
{
    const TemporaryFolder folder;
    view::write_vector_plot(folder / "a.svg", panels, "Title & more");
    const std::string text = bytes_of(folder / "a.svg");
    EXPECT_TRUE(text.starts_with("<svg "));
    EXPECT_THAT(text, HasSubstr("Title &amp; more"));
    EXPECT_THAT(text, HasSubstr("run &lt;1&gt;"));
    EXPECT_THAT(text, HasSubstr("area [mm²]"));
    EXPECT_THAT(text, HasSubstr("stroke=\"#0072b2\"")); // the first curve
    EXPECT_THAT(text, Not(HasSubstr("nan")));
    EXPECT_THAT(text, Not(HasSubstr("inf")));
}

TEST(VectorPlot, PlacesOfPointsAreThoseOfTheNumbers)
{
    view::VectorPage page(100, 100);
    page.line({{10, 20}, {30, 40}}, {0, 0, 1}, 2);
    EXPECT_THAT(page.svg(), HasSubstr("points=\"10.00,20.00 30.00,40.00\" stroke=\"#0000ff\""));
    EXPECT_THAT(page.pdf(), HasSubstr("10.00 80.00 m\n30.00 60.00 l\nS")); // a PDF counts from below
}

TEST(VectorPlot, PdfIsWhole)
{
    const TemporaryFolder folder;
    view::write_vector_plot(folder / "a.pdf", panels, "Title (1)");
    const std::string text = bytes_of(folder / "a.pdf");
    EXPECT_TRUE(text.starts_with("%PDF-1.4"));
    EXPECT_TRUE(text.ends_with("%%EOF\n"));
    EXPECT_THAT(text, HasSubstr("(Title \\(1\\))"));
    EXPECT_THAT(text, HasSubstr("(area [mm\xb2])")); // WinAnsi
    // Each object lies where the table says.
    const std::size_t table = text.find("xref\n");
    for (int k = 1; k <= 6; ++k)
    {
        const std::size_t entry = table + std::string("xref\n0 7\n").size() + 20 * static_cast<std::size_t>(k);
        const std::size_t place = std::stoul(text.substr(entry, 10));
        EXPECT_EQ(text.substr(place, 7), std::to_string(k) + " 0 obj") << k;
    }
}

TEST(VectorPlot, LettersAreAsWideAsInHelvetica)
{
    EXPECT_NEAR(view::text_width("Wii"), 0.944 + 2 * 0.222, 1e-9);
    EXPECT_NEAR(view::text_width("µ"), 0.556, 1e-9);
}

TEST(VectorPlot, ReportsWhereItCannotWrite)
{
    const TemporaryFolder folder;
    EXPECT_THROW(view::write_vector_plot(folder / "none/a.svg", panels, ""), RunError);
}

} // namespace corticle
