# What find_package(frostfill COMPONENTS core render) finds. Without components: both.
include(CMakePackageConfigHelpers)

set(public ${PROJECT_SOURCE_DIR}/include)
target_sources(frostfill_core PUBLIC FILE_SET HEADERS BASE_DIRS ${public} FILES
    ${public}/frostfill/columns.hpp
    ${public}/frostfill/error.hpp
    ${public}/frostfill/failure.hpp
    ${public}/frostfill/measure.hpp
    ${public}/frostfill/mesh.hpp
    ${public}/frostfill/options.hpp
    ${public}/frostfill/scene.hpp
    ${public}/frostfill/shard.hpp
    ${public}/frostfill/simulation.hpp
    ${public}/frostfill/snapshot.hpp
    ${public}/frostfill/sweep_file.hpp
    ${public}/frostfill/view.hpp)
target_sources(frostfill_render PUBLIC FILE_SET HEADERS BASE_DIRS ${public} FILES
    ${public}/frostfill/analysis.hpp
    ${public}/frostfill/bed.hpp
    ${public}/frostfill/export.hpp
    ${public}/frostfill/fill.hpp
    ${public}/frostfill/image.hpp
    ${public}/frostfill/import.hpp
    ${public}/frostfill/output.hpp
    ${public}/frostfill/packing.hpp
    ${public}/frostfill/page.hpp
    ${public}/frostfill/picture_settings.hpp
    ${public}/frostfill/plan_fill.hpp
    ${public}/frostfill/render_run.hpp
    ${public}/frostfill/renderer.hpp
    ${public}/frostfill/run_file.hpp
    ${public}/frostfill/shell.hpp
    ${public}/frostfill/sweep.hpp
    ${public}/frostfill/volume_estimate.hpp)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/frostfill)
foreach(component core render)
    set_target_properties(frostfill_${component} PROPERTIES EXPORT_NAME ${component})
    install(TARGETS frostfill_${component} EXPORT frostfill-${component}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        FILE_SET HEADERS COMPONENT development)
    install(EXPORT frostfill-${component} NAMESPACE frostfill:: DESTINATION ${package_dir}
        COMPONENT development)
endforeach()

# A static library does not carry the libraries that it uses: the consumer finds and links them.
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/frostfill-config.cmake @ONLY CONTENT [=[
include(CMakeFindDependencyMacro)
if(NOT frostfill_FIND_COMPONENTS)
    set(frostfill_FIND_COMPONENTS core render)
endif()
foreach(component IN LISTS frostfill_FIND_COMPONENTS)
    if(NOT component MATCHES "^(core|render|shared)$" OR
       NOT EXISTS ${CMAKE_CURRENT_LIST_DIR}/frostfill-${component}.cmake)
        set(frostfill_FOUND FALSE)
        set(frostfill_NOT_FOUND_MESSAGE "this install of frostfill has no component ${component}")
        if(component STREQUAL shared)
            string(APPEND frostfill_NOT_FOUND_MESSAGE ": build it with -DFROSTFILL_SHARED=ON")
        endif()
        return()
    endif()
    set(frostfill_${component}_FOUND TRUE)
endforeach()

find_dependency(Eigen3 3.4 NO_MODULE)
if("shared" IN_LIST frostfill_FIND_COMPONENTS)
    include(${CMAKE_CURRENT_LIST_DIR}/frostfill-shared.cmake)
endif()
if("core" IN_LIST frostfill_FIND_COMPONENTS OR "render" IN_LIST frostfill_FIND_COMPONENTS)
    find_dependency(assimp)
    find_dependency(ZLIB)
    find_dependency(fmt)
    find_dependency(TBB)
    find_dependency(tomlplusplus)
    include(${CMAKE_CURRENT_LIST_DIR}/frostfill-core.cmake)
endif()
if("render" IN_LIST frostfill_FIND_COMPONENTS)
    find_dependency(meshoptimizer)
    find_dependency(PkgConfig)
    pkg_check_modules(STB REQUIRED IMPORTED_TARGET stb)
    pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET libdeflate)
    pkg_check_modules(ISAL REQUIRED IMPORTED_TARGET libisal)
    pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
    include(${CMAKE_CURRENT_LIST_DIR}/frostfill-render.cmake)
endif()
]=])
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/frostfill-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/frostfill-config.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/frostfill-config-version.cmake
    DESTINATION ${package_dir} COMPONENT development)

# The same for pkg-config. Paths are relative to the file, so an install may be moved.
#   frostfill_pkg_config(NAME DESCRIPTION LIBRARY "REQUIRED PACKAGES" [LIBRARIES_WITHOUT_A_PACKAGE])
function(frostfill_pkg_config name description library packages)
    string(JOIN " " others ${ARGN})
    string(STRIP "-l${library} ${others}" libraries)
    set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
    file(RELATIVE_PATH up /${folder} /)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc @ONLY CONTENT [=[
prefix=${pcfiledir}/@up@
libdir=${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=${prefix}/@CMAKE_INSTALL_INCLUDEDIR@

Name: @name@
Description: @description@
Version: @PROJECT_VERSION@
Requires: @packages@
Libs: -L${libdir} @libraries@
Cflags: -I${includedir}
]=])
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${folder} COMPONENT development)
endfunction()
frostfill_pkg_config(frostfill-core "Frostfill's meshes, scenes and simulation (static)" frostfill_core
    "eigen3, assimp, fmt, tbb, tomlplusplus, zlib")
if(FROSTFILL_VORO)
    set(voro -l${FROSTFILL_VORO})
endif()
frostfill_pkg_config(frostfill-render "Frostfill with pictures and files (static)" frostfill_render
    "frostfill-core, stb, libdeflate, libisal, libzstd" -lmeshoptimizer ${voro})
if(FROSTFILL_SHARED)
    frostfill_pkg_config(frostfill "Fills a closed mesh with falling spheres and renders it"
        frostfill "eigen3")
else()
    install(CODE "message(STATUS \"Not in this build: the shared library (-DFROSTFILL_SHARED=ON)\")"
        COMPONENT library)
endif()
