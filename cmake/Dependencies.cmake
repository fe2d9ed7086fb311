# What Pliant is built from. Each package is looked for on the system first and in .deps, where scripts/prepare puts the
# pinned ones; elsewhere it is downloaded by its pinned tag. FETCHCONTENT_SOURCE_DIR_<NAME> points at a tree already there.
include(FetchContent)
set(PLIANT_DEPS_DIR ${PROJECT_SOURCE_DIR}/.deps)

# pliant_fetch(PACKAGE REPOSITORY TAG)
function(pliant_fetch package repository tag)
  set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)  # the settings below and of the caller hold in older projects too
  set(BUILD_TESTING OFF)
  FetchContent_Declare(${package} GIT_REPOSITORY ${repository} GIT_TAG ${tag} GIT_SHALLOW ON)
  FetchContent_MakeAvailable(${package})
  set_property(GLOBAL APPEND PROPERTY PLIANT_FETCHED ${package})
endfunction()

# pliant_find_or_fetch(PACKAGE TARGET REPOSITORY TAG [VERSION])
function(pliant_find_or_fetch package target repository tag)
  find_package(${package} ${ARGN} CONFIG QUIET)
  if(NOT TARGET ${target})
    message(STATUS "${package}: not on this system, building ${tag}")
    pliant_fetch(${package} ${repository} ${tag})
  endif()
endfunction()

# Code of others: its headers raise no warnings here, its sources are neither checked nor sanitised.
function(pliant_third_party target)
  if(NOT MSVC)
    target_compile_options(${target} PRIVATE -w)
    if(PLIANT_SANITIZE)
      target_compile_options(${target} PRIVATE -fno-sanitize=all)
    endif()
  endif()
endfunction()

# ---- The core ----
set(EIGEN_BUILD_DOC OFF)
pliant_find_or_fetch(Eigen3 Eigen3::Eigen https://gitlab.com/libeigen/eigen.git 3.4.0 3.4)
pliant_find_or_fetch(fmt fmt::fmt https://github.com/fmtlib/fmt.git 9.1.0)
pliant_find_or_fetch(nlohmann_json nlohmann_json::nlohmann_json https://github.com/nlohmann/json.git v3.11.2 3.11)
find_package(ZLIB REQUIRED)
pliant_find_or_fetch(pugixml pugixml::pugixml https://github.com/zeux/pugixml.git v1.13)
find_package(Threads REQUIRED)
include(ThreadDependencies)

if(PLIANT_BUILD_VIEWER)
  include(GraphicsDependencies)
endif()

if(PLIANT_BUILD_TESTS)
  list(APPEND CMAKE_PREFIX_PATH ${PLIANT_DEPS_DIR}/catch2/usr)
  pliant_find_or_fetch(Catch2 Catch2::Catch2WithMain https://github.com/catchorg/Catch2.git v3.7.1 3.7)
  if(Catch2_SOURCE_DIR)
    list(APPEND CMAKE_MODULE_PATH ${Catch2_SOURCE_DIR}/extras)
  elseif(Catch2_DIR)
    list(APPEND CMAKE_MODULE_PATH ${Catch2_DIR})
  endif()
endif()

if(PLIANT_BUILD_BENCHMARKS)
  set(BENCHMARK_ENABLE_TESTING OFF)
  pliant_find_or_fetch(benchmark benchmark::benchmark https://github.com/google/benchmark.git v1.7.1)
endif()
