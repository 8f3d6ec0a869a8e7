# Warnings and floating-point rules of every target of ours. Contraction off: a fused multiply-add
# rounds once where two operations round twice, so results would depend on the instruction set.
function(frostfill_configure target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -ffp-contract=off
        $<$<BOOL:${FROSTFILL_WERROR}>:-Werror>)
    # GCC stops inlining once a unit has grown by 40 %, which the unit of a whole room does: a fall took
    # 7 % more instructions. Here and not beside the rooms, because precompiled headers carry parameters.
    if(FROSTFILL_UNITY)
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=120>)
    endif()
    if(FROSTFILL_SANITIZE)
        target_compile_options(${target} PUBLIC -fsanitize=${FROSTFILL_SANITIZE} -fno-omit-frame-pointer)
        # With sanitizers GCC 12 takes parts of std::variant and std::regex for uninitialised.
        target_compile_options(${target} PUBLIC $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
        target_link_options(${target} PUBLIC -fsanitize=${FROSTFILL_SANITIZE})
    endif()
endfunction()

# The headers that most sources include, compiled once: twelve sources of library and tests took 42 %
# less processor time with GCC 12 (71 s without, 41 s with). The preset dev goes without, so that each
# source names what it uses. ccache needs the option, and CCACHE_SLOPPINESS=pch_defines,time_macros.
# The owner is a target that links nothing but what HEADERS need: GCC reads them only where every macro
# of the owner's command line is defined too.
#   frostfill_precompile(OWNER "LIBRARIES" HEADERS...), then frostfill_use_precompiled(TARGET OWNER)
function(frostfill_precompile owner libraries)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${owner}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "// Belongs to the precompiled headers.\n")
    add_library(${owner} OBJECT ${source})
    frostfill_configure(${owner})
    target_link_libraries(${owner} PRIVATE Eigen3::Eigen ${libraries})
    target_precompile_headers(${owner} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm> <array>
        <cmath> <filesystem> <functional> <map> <memory> <optional> <string> <vector> ${ARGN})
    frostfill_let_ccache_read(${owner})
endfunction()
function(frostfill_use_precompiled target owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
    frostfill_let_ccache_read(${target})
endfunction()
function(frostfill_let_ccache_read target)
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
        target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
endfunction()

# Compiles the sources of each room together, where FROSTFILL_UNITY says so, and those of the rooms of
# a joined group ("ROOM ROOM ..."): headers are read and their templates compiled once. The sources of
# simulation took some 75 s of processor time one by one, 59 s by folder, and take 26 s together. Names
# in nameless namespaces are unique in their room and group therefore. A unit takes up to 1.4 GB.
#   frostfill_join_rooms("TARGETS" "GROUP"...)
function(frostfill_join_rooms targets)
    if(NOT FROSTFILL_UNITY)
        return()
    endif()
    foreach(target IN LISTS targets)
        get_target_property(sources ${target} SOURCES)
        get_target_property(home ${target} SOURCE_DIR)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
        foreach(source IN LISTS sources)
            cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${home})
            file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR}/src ${source})
            string(REGEX REPLACE "/.*" "" room "${room}")
            foreach(group IN LISTS ARGN)
                if(" ${group} " MATCHES " ${room} ")
                    string(MAKE_C_IDENTIFIER "${group}" room)
                endif()
            endforeach()
            set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${room})
        endforeach()
    endforeach()
endfunction()

# Compiles units of a target small: rooms that read, write and plan. That takes three fifths of the
# time (76 s -> 45 s), and `analyse` 4 % longer, `fill torus` with pictures 1 %.
#   frostfill_compile_small(TARGET UNIT...)
function(frostfill_compile_small target)
    if(FROSTFILL_UNITY AND CMAKE_BUILD_TYPE STREQUAL Release)
        foreach(unit IN LISTS ARGN)
            set_source_files_properties(
                ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/Unity/unity_${unit}_cxx.cxx
                TARGET_DIRECTORY ${target} PROPERTIES COMPILE_OPTIONS -O1)
        endforeach()
    endif()
endfunction()

# Compiles files into a target, byte for byte, and writes the header that declares them:
#   frostfill_embed(TARGET ROOM/HEADER.hpp NAME FILE NAME FILE ...)
# In C++, with #include "ROOM/HEADER.hpp":
#   namespace frostfill::embedded { std::string_view NAME(); }
function(frostfill_embed target header)
    frostfill_embed_for("" ${target} ${header} ${ARGN})
    target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/embedded)
endfunction()

# The same, but only the given sources of the target see the header.
function(frostfill_embed_for sources target header)
    set(declarations "")
    list(LENGTH ARGN words)
    math(EXPR last "${words} - 1")
    foreach(i RANGE 0 ${last} 2)
        math(EXPR j "${i} + 1")
        list(GET ARGN ${i} name)
        list(GET ARGN ${j} file)
        frostfill_embed_one(${target} ${name} ${file})
        string(APPEND declarations "std::string_view ${name}();\n")
    endforeach()
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded)
    file(CONFIGURE OUTPUT ${folder}/${header} @ONLY CONTENT [=[
// Generated at configure time: files that the build compiles in. Functions have the files' names.
// NOLINTBEGIN(readability-identifier-naming)
#pragma once
#include <string_view>
namespace frostfill::embedded
{
@declarations@} // namespace frostfill::embedded
// NOLINTEND(readability-identifier-naming)
]=])
    if(sources)
        set_source_files_properties(${sources} TARGET_DIRECTORY ${target} PROPERTIES
            INCLUDE_DIRECTORIES ${folder})
    endif()
endfunction()

function(frostfill_embed_one target name file)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_${name}.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [=[
// Generated at configure time from @file@.
#include <string_view>
asm(".pushsection .rodata\n"
    ".balign 16\n"
    "frostfill_embedded_@name@_begin:\n"
    ".incbin \"@file@\"\n"
    "frostfill_embedded_@name@_end:\n"
    ".byte 0\n"
    ".popsection\n");
extern const char begin asm("frostfill_embedded_@name@_begin");
extern const char end asm("frostfill_embedded_@name@_end");
namespace frostfill::embedded
{
std::string_view @name@();
std::string_view @name@() { return {&begin, static_cast<std::size_t>(&end - &begin)}; }
} // namespace frostfill::embedded
]=])
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES
        OBJECT_DEPENDS ${file} SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
    target_sources(${target} PRIVATE ${source})
endfunction()
