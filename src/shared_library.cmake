# libfrostfill.so: core and render in one, of the same objects as the static libraries, so that it gives
# the same bits. It exports what the public headers declare; see tools/shared/export_public.py. While
# a minor version may change what is public, the minor version is part of the soname.
find_program(PYTHON3 python3 REQUIRED)
set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(objects ${CMAKE_CURRENT_BINARY_DIR}/libfrostfill.o)
set(exports ${CMAKE_CURRENT_BINARY_DIR}/libfrostfill.map)
set(export_public ${PROJECT_SOURCE_DIR}/tools/shared/export_public.py)
get_target_property(core_headers frostfill_core HEADER_SET)
get_target_property(render_headers frostfill_render HEADER_SET)
add_custom_command(OUTPUT ${objects} ${exports}
    COMMAND ${CMAKE_LINKER} -r -o ${objects} --whole-archive
        $<TARGET_FILE:frostfill_core> $<TARGET_FILE:frostfill_render>
    COMMAND ${PYTHON3} ${export_public}
        ${objects} ${exports} FROSTFILL_${soversion} ${core_headers} ${render_headers}
    DEPENDS frostfill_core frostfill_render ${export_public} ${core_headers} ${render_headers}
    VERBATIM)

add_library(frostfill_shared SHARED ${objects})
add_library(frostfill::shared ALIAS frostfill_shared)
set_source_files_properties(${objects} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
set_target_properties(frostfill_shared PROPERTIES
    OUTPUT_NAME frostfill EXPORT_NAME shared LINKER_LANGUAGE CXX
    VERSION ${PROJECT_VERSION} SOVERSION ${soversion} LINK_DEPENDS ${exports})
target_compile_features(frostfill_shared PUBLIC cxx_std_20)
target_include_directories(frostfill_shared PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# Symbolic: code that was compiled for hidden names reaches its own ones directly.
target_link_options(frostfill_shared PRIVATE
    -Wl,-Bsymbolic -Wl,--version-script=${exports} -Wl,--no-undefined -Wl,--as-needed)
target_link_libraries(frostfill_shared
    PUBLIC Eigen3::Eigen
    PRIVATE assimp::assimp fmt::fmt tomlplusplus::tomlplusplus
            meshoptimizer::meshoptimizer TBB::tbb
            PkgConfig::STB PkgConfig::DEFLATE PkgConfig::ISAL PkgConfig::ZSTD ${FROSTFILL_VORO} ${CMAKE_DL_LIBS})

install(TARGETS frostfill_shared EXPORT frostfill-shared
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(EXPORT frostfill-shared NAMESPACE frostfill:: DESTINATION ${package_dir} COMPONENT development)
