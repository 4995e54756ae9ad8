// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/packed.hpp"

#include "corticle/formats/encoding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace corticle
{

namespace
{

/// The bytes of base64 text without line breaks.
std::string from_base64(std::string_view text)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int held = 0;
    for (const char c : text.substr(0, text.find('=')))
    {
        bits = bits << 6 | static_cast<unsigned>(digits.find(c));
        held += 6;
        if (held >= 8)
        {
            held -= 8;
            bytes += static_cast<char>(bits >> held & 0xffu);
        }
    }
    return bytes;
}

/// What viewer/packing.mjs makes of an array of a page.
std::vector<double> unpacked(const report::Json& json, const report::Blobs& blobs)
{
    const std::size_t components = json["low"].size();
    const std::size_t count = json["count"];
    const std::string packed = from_base64(blobs.all()[json["blob"].get<std::size_t>()]);
    std::string planes(2 * components * count, '\0');
    EXPECT_TRUE(formats::unpack_zlib(packed, planes.data(), planes.size()));
    std::vector<double> values(components * count);
    std::uint16_t number = 0;
    for (std::size_t i = 0; i < components * count; ++i)
    {
        const auto low = static_cast<unsigned char>(planes[i]);
        const auto high = static_cast<unsigned char>(planes[components * count + i]);
        number = static_cast<std::uint16_t>(number + low + 256 * high);
        const std::size_t c = i / count;
        const double least = json["low"][c];
        const double largest = json["high"][c];
        values[components * (i % count) + c] =
            number == 65535 ? std::nan("") : least + (largest - least) * number / 65534.0;
    }
    return values;
}

} // namespace

TEST(Packed, NumbersComeBackToHalfAStep)
{
    std::vector<double> values;
    for (int i = 0; i < 1000; ++i)
    {
        values.insert(values.end(), {std::sin(0.1 * i), 100.0 + i * i, -3.0});
    }
    report::Blobs blobs;
    const report::Json json = report::pack_numbers(values, 3, blobs);
    const std::vector<double> back = unpacked(json, blobs);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        const double error = report::packing_error(json["low"][i % 3], json["high"][i % 3]);
        EXPECT_NEAR(back[i], values[i], 1.001 * error + 1e-12) << i;
    }
    EXPECT_DOUBLE_EQ(back[5], -3.0); // a constant is exact
}

TEST(Packed, CoarseNumbersAreSmallerAndComeBackToHalfTheirStep)
{
    std::vector<double> values;
    std::uint64_t state = 1;
    for (int i = 0; i < 4000; ++i) // noise, which does not deflate
    {
        state = state * 6364136223846793005u + 1442695040888963407u;
        values.push_back(static_cast<double>(state >> 40));
    }
    report::Blobs fine;
    report::Blobs coarse;
    report::pack_numbers(values, 1, fine);
    const report::Json json = report::pack_numbers(values, 1, coarse, 16);
    EXPECT_LT(static_cast<double>(coarse.bytes()),
              0.9 * static_cast<double>(fine.bytes())); // differences of 12 bits take 13 of 16 or 17
    const std::vector<double> back = unpacked(json, coarse);
    double largest = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        largest = std::max(largest, std::abs(back[i] - values[i]));
    }
    const double error = report::packing_error(json["low"][0], json["high"][0], 16);
    EXPECT_LE(largest, 1.001 * error);
    EXPECT_GT(largest, 0.9 * error);
}

TEST(Packed, WhatIsNoNumberStaysNone)
{
    report::Blobs blobs;
    const std::vector values{1.0, std::nan(""), 2.0};
    const std::vector<double> back = unpacked(report::pack_numbers(values, 1, blobs), blobs);
    EXPECT_DOUBLE_EQ(back[0], 1.0);
    EXPECT_TRUE(std::isnan(back[1]));
    EXPECT_DOUBLE_EQ(back[2], 2.0);
}

TEST(Page, NothingOfATextIsMarkup)
{
    EXPECT_EQ(report::escaped("<script>\"&'"), "&lt;script&gt;&quot;&amp;&#39;");
    report::Page page{"</title><script>", "a", {{"title", "</script><script>alert(1)</script>"}}, {}};
    const std::string text = report::html(page, {"library", "controls", "notice"});
    EXPECT_EQ(text.find("</title><script>"), std::string::npos);
    EXPECT_EQ(text.find("alert(1)</script>"), std::string::npos);
    EXPECT_EQ(text.find("{{"), std::string::npos);
}

} // namespace corticle
