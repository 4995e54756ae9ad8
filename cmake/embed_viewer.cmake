# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the files of viewer/ as strings of a C++ source. The modules become one script: in the order of their imports,
# without the lines of imports and the word export (each of these stands at the start of a line).
file(STRINGS ${VIEWER}/modules.txt in_order)
set(script "")
foreach(name IN LISTS in_order)
    file(READ ${VIEWER}/${name} text)
    string(REGEX REPLACE "\nimport [^\n]*" "" text "\n${text}")
    string(REGEX REPLACE "\nexport " "\n" text "${text}")
    string(APPEND script "${text}")
endforeach()
file(READ ${VIEWER}/style.css style)
file(READ ${VIEWER}/page.html page)
set(source "// Made by cmake/embed_viewer.cmake.\n#include \"corticle/report/viewer_files.hpp\"\n\nnamespace corticle::report\n{\n")
foreach(name script style page)
    string(APPEND source "const char* const viewer_${name} = R\"viewer(${${name}})viewer\";\n")
endforeach()
file(WRITE ${OUTPUT} "${source}} // namespace corticle::report\n")
