# Warnings and floating-point rules of every target of ours. Contraction off: a fused multiply-add
# rounds once where two operations round twice, so results would depend on the instruction set.
function(frostfill_configure target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -ffp-contract=off
        $<$<BOOL:${FROSTFILL_WERROR}>:-Werror>)
    if(FROSTFILL_SANITIZE)
        target_compile_options(${target} PUBLIC -fsanitize=${FROSTFILL_SANITIZE} -fno-omit-frame-pointer)
        target_link_options(${target} PUBLIC -fsanitize=${FROSTFILL_SANITIZE})
    endif()
endfunction()

# Compiles a file into a target, byte for byte. In C++:
#   namespace frostfill::embedded { std::string_view NAME(); }
function(frostfill_embed target name file)
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
    set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${file})
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES OBJECT_DEPENDS ${file})
    target_sources(${target} PRIVATE ${source})
endfunction()
