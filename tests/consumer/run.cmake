# Installs pliant::core into an empty prefix, then configures, builds and runs the project in this folder against it.
#   cmake -DBUILD=<build folder of Pliant> -DWORK=<scratch folder> -DCOMPILER=<C++ compiler> [-DFLAGS=<compiler flags>] -P run.cmake
cmake_minimum_required(VERSION 3.22)
foreach(needed IN ITEMS BUILD WORK COMPILER)
  if(NOT ${needed})
    message(FATAL_ERROR "run.cmake needs -D${needed}=...")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    string(REPLACE ";" " " command "${ARGV}")
    message(FATAL_ERROR "failed with ${status}: ${command}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --component pliant_core)

# Headers and nothing but headers are installed, and they find all that they include.
set(every_header "")
file(GLOB_RECURSE installed RELATIVE ${WORK}/prefix/include ${WORK}/prefix/include/*)
foreach(file IN LISTS installed)
  if(NOT file MATCHES "^pliant/.*\\.h$")
    message(FATAL_ERROR "include/${file} is installed and is no header of the core")
  endif()
  string(APPEND every_header "#include <${file}>\n")
endforeach()
file(WRITE ${WORK}/every_header.cpp "${every_header}")

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
  -DEVERY_HEADER=${WORK}/every_header.cpp
  -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
