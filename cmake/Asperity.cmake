# Flags shared by every target, and the one way to declare a core folder.

add_library(asperity_flags INTERFACE)
# No fused multiply-add and no contraction: the same bytes on every instruction set.
target_compile_options(asperity_flags INTERFACE -ffp-contract=off -fno-math-errno)
add_library(asperity_warnings INTERFACE)
target_compile_options(asperity_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
# g++ 12 reports false positives of these two in inlined std::string and std::variant (GCC bugs 105651, 105562).
target_compile_options(asperity_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>)
if(ASPERITY_WARNINGS_AS_ERRORS)
  target_compile_options(asperity_warnings INTERFACE -Werror)
endif()

# asperity_core(NAME [DEPENDS core folders...] [LIBRARIES other targets...]): the library of one core folder, asperity_NAME.
function(asperity_core name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(asperity_${name} STATIC ${sources})
  target_include_directories(asperity_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  list(TRANSFORM ARG_DEPENDS PREPEND asperity_)
  target_link_libraries(asperity_${name} PUBLIC asperity_flags ${ARG_DEPENDS} ${ARG_LIBRARIES}
                        PRIVATE asperity_warnings ${ARG_PRIVATE_LIBRARIES})
endfunction()
