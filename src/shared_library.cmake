# libfrostfill.so: core and render in one, of the same objects as the static libraries, so that it gives
# the same bits. Sources are compiled with hidden names; the public headers declare theirs visible. While
# a minor version may change what is public, the minor version is part of the soname.
set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
# Names of ours alone: the standard library declares its templates visible.
set(exports ${CMAKE_CURRENT_BINARY_DIR}/libfrostfill.map)
file(CONFIGURE OUTPUT ${exports} CONTENT [=[
FROSTFILL_@soversion@ { global: _ZN9frostfill*; _ZNK9frostfill*; _ZT?N9frostfill*; local: *; };
]=])

add_library(frostfill_shared SHARED $<TARGET_OBJECTS:frostfill_core> $<TARGET_OBJECTS:frostfill_render>)
add_library(frostfill::shared ALIAS frostfill_shared)
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
    PRIVATE assimp::assimp fmt::fmt tomlplusplus::tomlplusplus ZLIB::ZLIB
            meshoptimizer::meshoptimizer TBB::tbb
            PkgConfig::STB PkgConfig::DEFLATE PkgConfig::ISAL PkgConfig::ZSTD ${FROSTFILL_VORO} ${CMAKE_DL_LIBS})

install(TARGETS frostfill_shared EXPORT frostfill-shared
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(EXPORT frostfill-shared NAMESPACE frostfill:: DESTINATION ${package_dir} COMPONENT development)
