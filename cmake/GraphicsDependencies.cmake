# What the lab and its pictures are built from.
#   CLI11::CLI11 PNG::PNG GIF::GIF
#   pliant_haru          libharu, which writes PDF files
#   pliant_glad          the functions of OpenGL 3.3 core, <glad/gl.h>, generated here
#   pliant_imgui         Dear ImGui 1.90.1 with its GLFW and OpenGL 3 backends, <imgui.h>, <backends/...>
#   pliant_gl_platforms  what can make a GL context on this machine; defines PLIANT_HAVE_GLFW, PLIANT_HAVE_OSMESA and
#                        PLIANT_HAVE_EGL as 1 or 0, so that a machine without one of them still builds
pliant_find_or_fetch(CLI11 CLI11::CLI11 https://github.com/CLIUtils/CLI11.git v2.1.2)
find_package(PNG REQUIRED)
find_package(GIF 5.1 REQUIRED)

# ---- Ways to a GL context ----
add_library(pliant_gl_platforms INTERFACE)
target_compile_definitions(pliant_gl_platforms INTERFACE GLFW_INCLUDE_NONE)

function(pliant_gl_platform name found)
  if(found)
    target_link_libraries(pliant_gl_platforms INTERFACE ${ARGN})
    target_compile_definitions(pliant_gl_platforms INTERFACE PLIANT_HAVE_${name}=1)
  else()
    message(STATUS "${name}: not on this system, building without")
    target_compile_definitions(pliant_gl_platforms INTERFACE PLIANT_HAVE_${name}=0)
  endif()
  set(PLIANT_HAVE_${name} ${found} PARENT_SCOPE)
endfunction()

# A library that has neither a CMake package nor anything but one header and one file.
function(pliant_find_plain target header library)
  find_path(${target}_INCLUDE_DIR ${header})
  find_library(${target}_LIBRARY ${library})
  mark_as_advanced(${target}_INCLUDE_DIR ${target}_LIBRARY)
  if(${target}_INCLUDE_DIR AND ${target}_LIBRARY)
    add_library(${target} INTERFACE)
    target_include_directories(${target} SYSTEM INTERFACE ${${target}_INCLUDE_DIR})
    target_link_libraries(${target} INTERFACE ${${target}_LIBRARY})
  endif()
endfunction()

pliant_find_plain(pliant_haru hpdf.h hpdf)
if(NOT TARGET pliant_haru)
  message(FATAL_ERROR "libharu is missing, which writes PDF files: install libhpdf-dev (Debian), libharu-devel (Fedora) or libharu (Homebrew)")
endif()

if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  find_package(glfw3 3.3 CONFIG QUIET)
  # Loaded by the first context that asks for it, so only its header is needed here.
  find_path(pliant_osmesa_INCLUDE_DIR GL/osmesa.h)
  mark_as_advanced(pliant_osmesa_INCLUDE_DIR)
  if(pliant_osmesa_INCLUDE_DIR)
    add_library(pliant_osmesa INTERFACE)
    target_include_directories(pliant_osmesa SYSTEM INTERFACE ${pliant_osmesa_INCLUDE_DIR})
    target_link_libraries(pliant_osmesa INTERFACE ${CMAKE_DL_LIBS})
  endif()
  pliant_find_plain(pliant_egl EGL/egl.h EGL)
elseif(NOT EMSCRIPTEN)
  set(GLFW_BUILD_DOCS OFF)
  set(GLFW_BUILD_TESTS OFF)
  set(GLFW_BUILD_EXAMPLES OFF)
  set(GLFW_INSTALL OFF)
  pliant_find_or_fetch(glfw3 glfw https://github.com/glfw/glfw.git 3.3.8 3.3)
endif()
foreach(platform IN ITEMS GLFW:glfw OSMESA:pliant_osmesa EGL:pliant_egl)
  string(REPLACE ":" ";" platform ${platform})
  list(GET platform 0 name)
  list(GET platform 1 target)
  if(TARGET ${target})
    pliant_gl_platform(${name} TRUE ${target})
  else()
    pliant_gl_platform(${name} FALSE)
  endif()
endforeach()

# ---- The functions of OpenGL ----
find_program(GLAD_PROGRAM glad REQUIRED)
set(glad ${PROJECT_BINARY_DIR}/glad)
add_custom_command(
  OUTPUT ${glad}/src/gl.c ${glad}/include/glad/gl.h ${glad}/include/KHR/khrplatform.h
  COMMAND ${GLAD_PROGRAM} --quiet --reproducible --api gl:core=3.3 --out-path ${glad} c
  COMMENT "Generating the functions of OpenGL 3.3"
  VERBATIM)
add_library(pliant_glad STATIC ${glad}/src/gl.c ${glad}/include/glad/gl.h)
set_source_files_properties(${glad}/src/gl.c PROPERTIES LANGUAGE CXX)
target_include_directories(pliant_glad SYSTEM PUBLIC ${glad}/include)
pliant_third_party(pliant_glad)

# ---- Dear ImGui ----
if(EXISTS ${PLIANT_DEPS_DIR}/imgui/imgui.h AND NOT FETCHCONTENT_SOURCE_DIR_IMGUI)
  set(FETCHCONTENT_SOURCE_DIR_IMGUI ${PLIANT_DEPS_DIR}/imgui)
endif()
FetchContent_Declare(imgui GIT_REPOSITORY https://github.com/ocornut/imgui.git GIT_TAG v1.90.1 GIT_SHALLOW ON)
FetchContent_MakeAvailable(imgui)

add_library(pliant_imgui STATIC
  ${imgui_SOURCE_DIR}/imgui.cpp
  ${imgui_SOURCE_DIR}/imgui_draw.cpp
  ${imgui_SOURCE_DIR}/imgui_tables.cpp
  ${imgui_SOURCE_DIR}/imgui_widgets.cpp
  ${imgui_SOURCE_DIR}/backends/imgui_impl_opengl3.cpp
  $<$<BOOL:${PLIANT_HAVE_GLFW}>:${imgui_SOURCE_DIR}/backends/imgui_impl_glfw.cpp>)
# The backend takes its GL functions from glad, whose header it does not know.
set_source_files_properties(${imgui_SOURCE_DIR}/backends/imgui_impl_opengl3.cpp PROPERTIES
  COMPILE_OPTIONS "$<IF:$<CXX_COMPILER_ID:MSVC>,/FI,-include>;glad/gl.h")
# The slanted letters of formulas have code points above 16 bits.
target_compile_definitions(pliant_imgui PUBLIC IMGUI_DISABLE_OBSOLETE_FUNCTIONS IMGUI_USE_WCHAR32 PRIVATE IMGUI_IMPL_OPENGL_LOADER_CUSTOM)
target_include_directories(pliant_imgui SYSTEM PUBLIC ${imgui_SOURCE_DIR} ${imgui_SOURCE_DIR}/backends)
target_link_libraries(pliant_imgui PUBLIC pliant_glad PRIVATE pliant_gl_platforms)
pliant_third_party(pliant_imgui)
