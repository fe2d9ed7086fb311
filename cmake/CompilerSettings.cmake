# One set of compiler settings for every target of the project.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
if(MSVC)
  set(CMAKE_CXX_FLAGS_RELEASE "/O2")
else()
  # Assertions of Eigen stay on in debug builds only; -O2 is as fast as -O3 here and compiles sooner.
  set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
endif()

# Eigen's headers read once per target instead of once per file: a build from nothing takes a third less. Off unless asked
# for (the presets do), so that some builds still show that every file includes what it uses.
option(PLIANT_PRECOMPILE "Precompile the headers of Eigen" OFF)
if(NOT PLIANT_PRECOMPILE)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  if(PLIANT_PRECOMPILE)
    # ccache keeps what was compiled with a precompiled header only under these settings.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
    endif()
  endif()
endif()

if(PLIANT_SANITIZE)
  add_compile_options(-fsanitize=${PLIANT_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${PLIANT_SANITIZE})
  if(PLIANT_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize-recover=undefined)
  endif()
endif()
if(PLIANT_BUILD_FUZZERS)
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

# Same input, same bits: no contraction of a*b+c, so the same source gives the same rounding on every target.
add_library(pliant_settings INTERFACE)
if(NOT MSVC)
  target_compile_options(pliant_settings INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wfloat-conversion)
  if(PLIANT_WARNINGS_AS_ERRORS)
    target_compile_options(pliant_settings INTERFACE -Werror)
  endif()
endif()

# What computes little of its own: what a lesson declares, says and draws, what runs and writes it, the lab, the tests. It compiles a
# quarter sooner so, with a precompiled header of the same level.
add_library(pliant_light_settings INTERFACE)
target_link_libraries(pliant_light_settings INTERFACE pliant_settings)
if(NOT MSVC)
  target_compile_options(pliant_light_settings INTERFACE $<$<CONFIG:Release>:-O1>)
  # At -O1 it does not follow what Eigen sets.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(pliant_light_settings INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()
