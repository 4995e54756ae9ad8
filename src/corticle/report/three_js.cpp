// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/three_js.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace corticle::report
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* notice = R"(three.js, Copyright (c) 2010-2019 three.js authors

The MIT License

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.)";

/// A script as an element of a page may hold it: nothing in it ends the element.
std::string read_script(const fs::path& file)
{
    std::error_code error;
    if (!fs::is_regular_file(file, error))
    {
        throw RunError(
            fmt::format("no report: three.js is not installed (no {}); apt-get install libjs-three", file.string()));
    }
    std::string text = formats::read_whole_file(file);
    for (std::size_t at = text.find("</script"); at != std::string::npos; at = text.find("</script", at))
    {
        text.replace(at, 2, "<\\/");
    }
    return text;
}

} // namespace

fs::path three_js_folder()
{
    const char* const chosen = std::getenv("CORTICLE_THREE_JS");
    return chosen != nullptr ? chosen : "/usr/share/javascript/three";
}

ThreeJs read_three_js(const fs::path& folder)
{
    return {read_script(folder / "three.min.js"), read_script(folder / "examples/js/controls/OrbitControls.js"),
            notice};
}

} // namespace corticle::report
