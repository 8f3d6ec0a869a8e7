cmake_minimum_required(VERSION 3.25)

# Packs what is built and looks into the packages.
find_program(DPKG_DEB dpkg-deb)
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
find_program(HELP2MAN help2man)
if(NOT DPKG_DEB OR NOT DPKG_SHLIBDEPS OR NOT HELP2MAN)
    message("Skipped: dpkg-dev and help2man make and read packages; install them")
    return()
endif()
set(ENV{SOURCE_DATE_EPOCH} 1700000000)
file(REMOVE_RECURSE ${PACKAGES})
execute_process(COMMAND ${CPACK} -B ${PACKAGES} WORKING_DIRECTORY ${BUILD}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

function(expect_in_package name)
    file(GLOB package ${PACKAGES}/${name}_*.deb)
    execute_process(COMMAND ${DPKG_DEB} --contents ${package} OUTPUT_VARIABLE contents
        COMMAND_ERROR_IS_FATAL ANY)
    foreach(pattern IN LISTS ARGN ITEMS "/doc/${name}/copyright" "/doc/${name}/changelog.Debian.gz")
        if(NOT contents MATCHES "${pattern}")
            message(SEND_ERROR "${name} has no ${pattern}:\n${contents}")
        endif()
    endforeach()
    # Everything is root's, and of the time that was asked for.
    string(REGEX MATCHALL "[^\n]+" lines "${contents}")
    foreach(line IN LISTS lines)
        if(NOT line MATCHES "^[^ ]+ root/root +[0-9]+ 2023-11-1[45] ")
            message(SEND_ERROR "${name}: ${line}")
        endif()
    endforeach()
endfunction()
expect_in_package(frostfill /usr/bin/frostfill /man1/frostfill.1.gz /completions/frostfill)
expect_in_package(libfrostfill${SOVERSION} "/libfrostfill\\.so\\.${SOVERSION} -> ")
expect_in_package(libfrostfill-dev /frostfill/fill.hpp /libfrostfill_render.a "/libfrostfill\\.so -> "
    /frostfill-config.cmake /pkgconfig/frostfill.pc)
expect_in_package(python3-frostfill /usr/lib/python3/dist-packages/frostfill/__init__.py
    /usr/lib/python3/dist-packages/frostfill/_frostfill)
