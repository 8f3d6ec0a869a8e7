# CPack runs this after it has put the files of each package into a folder of its own, and before it
# makes packages of them: what Debian wants in a package and an install elsewhere does not.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
    message(FATAL_ERROR "Packages are made by scripts/package, which sets SOURCE_DATE_EPOCH")
endif()
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    set(root ${CPACK_TEMPORARY_DIRECTORY}/${component})
    set(documentation ${root}/usr/share/doc/${package})
    if(NOT EXISTS ${root}/usr)
        message(FATAL_ERROR "Nothing was installed for ${package}, into ${root}")
    endif()

    configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright ${documentation}/copyright COPYONLY)
    file(WRITE ${documentation}/changelog.Debian "frostfill (${CPACK_PACKAGE_VERSION}-\
${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Made by scripts/package; changelog.gz says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
    configure_file(${CPACK_FROSTFILL_SOURCE}/CHANGELOG.md ${documentation}/changelog COPYONLY)
    # The manual page is what the program says of itself.
    set(page)
    if(component STREQUAL program)
        set(page ${root}/usr/share/man/man1/frostfill.1)
        file(MAKE_DIRECTORY ${root}/usr/share/man/man1)
        execute_process(
            COMMAND help2man --no-info --name "fill a mesh with falling spheres and draw it"
                --output ${page} ${root}/usr/bin/frostfill
            COMMAND_ERROR_IS_FATAL ANY)
    endif()
    execute_process(
        COMMAND gzip -9n ${documentation}/changelog.Debian ${documentation}/changelog ${page}
        COMMAND_ERROR_IS_FATAL ANY)
    # Nothing tells when or by whom the packages were made.
    execute_process(COMMAND chmod -R u=rwX,go=rX ${root} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND find ${root} -exec touch -h -d @$ENV{SOURCE_DATE_EPOCH} {} +
        COMMAND_ERROR_IS_FATAL ANY)
endforeach()
