cmake_minimum_required(VERSION 3.25)

# Builds and runs a program with what pkg-config says of an install, and nothing else.
find_program(PKG_CONFIG pkg-config)
if(NOT PKG_CONFIG)
    message("Skipped: pkg-config is not installed")
    return()
endif()
set(ENV{PKG_CONFIG_PATH} ${LIBRARIES}/pkgconfig)
set(ENV{LD_LIBRARY_PATH} ${LIBRARIES})
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
file(MAKE_DIRECTORY ${FOLDER})

function(try_module module source)
    execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${module}
        OUTPUT_VARIABLE options OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(options UNIX_COMMAND "${options}")
    execute_process(COMMAND ${COMPILER} -std=c++20 ${flags} ${source} ${options} -o ${module}
        WORKING_DIRECTORY ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${FOLDER}/${module} WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${source}, built by pkg-config's options for ${module}, ended with ${result}")
    endif()
endfunction()

try_module(frostfill-core ${CONSUMER}/count_spheres.cpp)
try_module(frostfill-render ${CONSUMER}/fill.cpp)
file(REMOVE_RECURSE ${FOLDER}/torus)
if(EXISTS ${LIBRARIES}/pkgconfig/frostfill.pc)
    try_module(frostfill ${CONSUMER}/fill.cpp)
    file(REMOVE_RECURSE ${FOLDER}/torus)
endif()
