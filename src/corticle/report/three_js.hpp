// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace corticle::report
{

/// three.js as it is installed on this machine (docs/decisions/three-js.md).
struct ThreeJs
{
    std::string library;  ///< three.min.js
    std::string controls; ///< OrbitControls.js
    std::string notice;   ///< its licence
};

/// Where Debian's package libjs-three puts it, or what CORTICLE_THREE_JS names instead.
std::filesystem::path three_js_folder();

/// @throws RunError, one line that says how to get it, where it is missing
ThreeJs read_three_js(const std::filesystem::path& folder = three_js_folder());

} // namespace corticle::report
