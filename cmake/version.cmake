# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT, the source file with the version and, in a Git checkout, the commit that is built. Rewritten only where it changes.
set(commit "")
find_program(git git)
if(git)
    execute_process(COMMAND ${git} -C ${SOURCE} describe --always --dirty=+changes --exclude=* --abbrev=12
        OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(commit)
    string(APPEND VERSION " (${commit})")
endif()
configure_file(${SOURCE}/cmake/version.cpp.in ${OUTPUT} @ONLY)
