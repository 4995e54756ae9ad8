// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle::report
{

// The files of viewer/, embedded when the program is built (cmake/embed_viewer.cmake).

extern const char* const viewer_script; ///< all modules as one
extern const char* const viewer_style;
extern const char* const viewer_page; ///< HTML with places, {{name}}, for what a report fills in

} // namespace corticle::report
