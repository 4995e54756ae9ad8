# SPDX-License-Identifier: GPL-3.0-or-later
# What `make install` installs: the program (component program; what `make package` packs) and, for C++, its libraries and
# headers with a CMake package (component development).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # neither needs the tests

set(CORTICLE_CONTACT "maintainers@corticle.invalid" CACHE STRING "Whom the Debian package names as its maintainer's address")
set(CPACK_PACKAGE_CONTACT "The Corticle maintainers <${CORTICLE_CONTACT}>")

# The program that meshes is started by the command alone: not in anyone's path.
install(TARGETS corticle_command RUNTIME COMPONENT program)
install(TARGETS corticle_tetrahedralize RUNTIME DESTINATION libexec/corticle COMPONENT program)

# Manual page and completions, from the command itself.
set(pages ${PROJECT_BINARY_DIR}/pages)
file(MAKE_DIRECTORY ${pages})
find_program(gzip gzip REQUIRED)
install(CODE "
    foreach(form man bash zsh fish)
        execute_process(COMMAND $<TARGET_FILE:corticle_command> schema --of-command \${form} OUTPUT_FILE ${pages}/\${form}
            COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
    execute_process(COMMAND ${gzip} -9nkf ${pages}/man ${pages}/changelog ${pages}/NEWS.md COMMAND_ERROR_IS_FATAL ANY)"
    COMPONENT program)
set(share ${CMAKE_INSTALL_DATADIR})
install(FILES ${pages}/man.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME corticle.1.gz COMPONENT program)
install(FILES ${pages}/bash DESTINATION ${share}/bash-completion/completions RENAME corticle COMPONENT program)
install(FILES ${pages}/zsh DESTINATION ${share}/zsh/vendor-completions RENAME _corticle COMPONENT program)
install(FILES ${pages}/fish DESTINATION ${share}/fish/vendor_completions.d RENAME corticle.fish COMPONENT program)

# Documents, by Debian's names.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(packaging/changelog.in ${pages}/changelog @ONLY)
configure_file(CHANGELOG.md ${pages}/NEWS.md COPYONLY)
set(documents ${share}/doc/corticle)
install(FILES README.md CITATION.cff packaging/copyright ${pages}/changelog.gz ${pages}/NEWS.md.gz DESTINATION ${documents}
    COMPONENT program)
install(DIRECTORY docs DESTINATION ${documents} COMPONENT program PATTERN "api" EXCLUDE)
install(DIRECTORY cases/ DESTINATION ${documents}/examples COMPONENT program)

# find_package(Corticle): headers, libraries, and where they find their own.
install(TARGETS ${corticle_libraries} EXPORT CorticleTargets ARCHIVE COMPONENT development)
install(DIRECTORY src/corticle DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.hpp")
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Corticle)
install(EXPORT CorticleTargets NAMESPACE Corticle:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(cmake/CorticleConfig.cmake.in ${PROJECT_BINARY_DIR}/CorticleConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/CorticleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/CorticleConfig.cmake ${PROJECT_BINARY_DIR}/CorticleConfigVersion.cmake DESTINATION ${package}
    COMPONENT development)

# `make package`: a Debian package of the program; what it depends on is read from what it is linked with.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME corticle)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"A growing cortex buckles on white matter that does not grow. Corticle computes
this by total-Lagrangian smoothed particle hydrodynamics or by finite elements,
with self-contact, on analytic shapes, surfaces, tet meshes and segmented
images, and writes surfaces, measures, pictures and a report.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program)
if(CORTICLE_PYTHON_MODULE)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME corticle)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libjs-three, xvfb, libgl1-mesa-dri") # report.html; pictures without a display
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg, paraview")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-corticle)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"Python package: cases, simulations, run folders, measures and comparisons, with
forces, growth laws and fields of one's own.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pandas, python3-nibabel, python3-matplotlib")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
include(CPack)
