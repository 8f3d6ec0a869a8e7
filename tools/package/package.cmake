# Debian packages, one for each component of the install. scripts/package makes them;
# docs/install.md lists them.
set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(version ${PROJECT_VERSION}-1)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME frostfill)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The Frostfill developers <maintainers@frostfill.invalid>" CACHE STRING
    "Maintainer of the packages: NAME <ADDRESS>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
# The first line of each description below is the summary.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
# Copyright, changelog and manual page, compressed; the file reads the changelog from here.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/finish.cmake)
set(CPACK_FROSTFILL_SOURCE ${PROJECT_SOURCE_DIR})

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program library development python)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SOURCE frostfill)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The module asks for a library that is in no installed package yet: the dependency is named below.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src)

# OpenGL, for --backend: found at run time, so dpkg-shlibdeps does not see it.
set(opengl "libosmesa6, libegl1")
set(does "Frostfill fills a closed triangle mesh with spheres that fall, collide and
freeze where they come to rest. Spheres and polygons that nothing can touch
any more are discarded, so a time step costs the same however many spheres
there are. It draws every frame without a screen.
")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME frostfill)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "${opengl}, python3-matplotlib")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "fill a mesh with falling spheres and draw it
${does}.
This package has the program, its manual page and its completion for bash.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libfrostfill${soversion})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS ${opengl})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/library/triggers)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "fill a mesh with falling spheres - shared library
${does}.
This package has the shared library.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfrostfill-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
if(VORO_LIBRARY)
    set(voro voro++-dev)
endif()
string(JOIN ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libfrostfill${soversion} (= ${version})" libassimp-dev libdeflate-dev libeigen3-dev libfmt-dev
    libisal-dev libmeshoptimizer-dev libstb-dev libtbb-dev libtomlplusplus-dev libzstd-dev pkgconf
    ${voro} zlib1g-dev)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "fill a mesh with falling spheres - development files
${does}.
This package has the headers, the static libraries, and what CMake and
pkg-config need to find them.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-frostfill)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if(Python_FOUND)
    # The module is for one version of Python, as its name says.
    math(EXPR next "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libfrostfill${soversion} (= ${version}), python3-numpy, \
python3 (<< 3.${next}), python3 (>= 3.${Python_VERSION_MINOR}~)")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_LIST_DIR}/python/postinst ${CMAKE_CURRENT_LIST_DIR}/python/prerm)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "fill a mesh with falling spheres - Python 3 module
${does}.
This package has the module frostfill, which gives states as arrays of NumPy.")

include(CPack)
