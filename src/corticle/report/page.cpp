// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/page.hpp"

#include "corticle/formats/encoding.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/report/viewer_files.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>

namespace corticle::report
{

namespace
{

/// JSON that may stand in a script element: nothing in it opens or ends an element or a comment.
std::string script_json(const Json& json)
{
    std::string text;
    for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    {
        text += c == '<' ? "\\u003c" : std::string(1, c);
    }
    return text;
}

/// The template with each {{name}} replaced by what belongs there.
std::string filled(std::string_view form, const std::map<std::string, std::string, std::less<>>& places)
{
    std::string text;
    for (std::size_t open = form.find("{{"); open != std::string_view::npos; open = form.find("{{"))
    {
        const std::size_t close = form.find("}}", open);
        text += form.substr(0, open);
        text += places.at(std::string(form.substr(open + 2, close - open - 2)));
        form.remove_prefix(close + 2);
    }
    return text.append(form);
}

std::string blob_elements(const Blobs& blobs)
{
    std::string text;
    text.reserve(blobs.bytes() + 80 * blobs.all().size());
    for (std::size_t k = 0; k < blobs.all().size(); ++k)
    {
        text += fmt::format("<script type=\"application/octet-stream\" id=\"blob-{}\">", k);
        text += blobs.all()[k];
        text += "</script>\n";
    }
    return text;
}

} // namespace

std::size_t Blobs::add(std::string base64)
{
    bytes_ += base64.size();
    all_.push_back(std::move(base64));
    return all_.size() - 1;
}

std::string escaped(std::string_view text)
{
    std::string result;
    for (const char c : text)
    {
        switch (c)
        {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

std::string html(const Page& page, const ThreeJs& three)
{
    return filled(viewer_page, {{"title", escaped(page.title)},
                                {"abstract", escaped(page.abstract)},
                                {"style", viewer_style},
                                {"content", script_json(page.content)},
                                {"blobs", blob_elements(page.blobs)},
                                {"three", three.library},
                                {"controls", three.controls},
                                {"notice", escaped(three.notice)},
                                {"script", viewer_script}});
}

std::string image_source(const std::filesystem::path& png)
{
    std::error_code error;
    return std::filesystem::is_regular_file(png, error)
               ? "data:image/png;base64," + formats::to_base64(formats::read_whole_file(png))
               : std::string();
}

} // namespace corticle::report
