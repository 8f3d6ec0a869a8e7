cmake_minimum_required(VERSION 3.25)

# The README shows the example that is compiled, letter for letter.
file(READ ${README} readme)
file(READ ${EXAMPLE} example)
string(FIND "${readme}" "```cpp\n${example}```" position)
if(position EQUAL -1)
    message(FATAL_ERROR "README.md does not show ${EXAMPLE} as it is")
endif()
