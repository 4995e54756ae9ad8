// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/report/three_js.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::report
{

using Json = nlohmann::ordered_json;

/// Arrays of a page, packed; the content names them by number.
class Blobs
{
  public:
    /// Returns the number of the array.
    std::size_t add(std::string base64);
    std::size_t bytes() const { return bytes_; }
    const std::vector<std::string>& all() const { return all_; }

  private:
    std::vector<std::string> all_;
    std::size_t bytes_ = 0;
};

/// What a page shows: what the script of the viewer reads, and what is read without it.
struct Page
{
    std::string title;
    std::string abstract; ///< one sentence, for readers without scripts and for search
    Json content;
    Blobs blobs;
};

/// The text with the characters of HTML escaped, fit for an element and for an attribute.
std::string escaped(std::string_view text);

/// The page as one HTML file that refers to nothing outside.
std::string html(const Page& page, const ThreeJs& three);

/// A PNG as the src of an image; empty where there is no such file.
std::string image_source(const std::filesystem::path& png);

} // namespace corticle::report
