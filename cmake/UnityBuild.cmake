# Files of a folder compiled as one unit: the headers that they share are read once, and what they share of templates is made
# once, so that a build from nothing takes a fraction of the time. Off where people edit (preset `edit`): there a change
# compiles one file.
option(PLIANT_UNITY "Compile the files of a folder together" OFF)

# A unit has room for its garbage: collecting it takes GCC a tenth of the time.
if(PLIANT_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:--param ggc-min-expand=200 --param ggc-min-heapsize=1000000>")
endif()

# Clang also tells of names that hide those of a file before them in the unit.
if(PLIANT_UNITY AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(pliant_settings INTERFACE -Wno-shadow)
endif()

# Files that read and write JSON or the command line: these libraries take seconds in each unit that has one of them.
set(pliant_heavy_includes "#include [<\"](nlohmann/|CLI/|.*/json_positions.h|.*/report_json.h)")

# pliant_unit_folder(FILE): the folder of the calling one in which the file lies, or in its folder of headers and sources
# `pliant`, to `folder`.
function(pliant_unit_folder file)
  get_filename_component(path ${file} ABSOLUTE)
  file(RELATIVE_PATH relative ${CMAKE_CURRENT_SOURCE_DIR} ${path})
  string(REGEX REPLACE "^(pliant/)?([^/]*)/.*" "\\2" folder ${relative})
  set(folder ${folder} PARENT_SCOPE)
endfunction()

# pliant_sort_heavy(SOURCES...): the files of each folder in their order, those with heavy includes after the others, to `sorted`.
function(pliant_sort_heavy)
  set(keyed "")
  foreach(source IN LISTS ARGN)
    pliant_unit_folder(${source})
    file(STRINGS ${source} heavy REGEX "${pliant_heavy_includes}" LIMIT_COUNT 1)
    string(COMPARE NOTEQUAL "${heavy}" "" late)
    list(APPEND keyed "${folder}|${late}|${source}")
  endforeach()
  list(SORT keyed)
  list(TRANSFORM keyed REPLACE ".*[|]" "")
  set(sorted "${keyed}" PARENT_SCOPE)
endfunction()

# pliant_unity(TARGET BYTES FILES...): the files of each folder that lies in the calling one, with those of the folders in it, in
# units of at most BYTES of source.
function(pliant_unity target most)
  if(NOT PLIANT_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # In a unit every file is an included one, whose anonymous namespaces GCC takes for those of a header.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
  set(before "")
  set(filled 0)
  pliant_sort_heavy(${ARGN})
  foreach(source IN LISTS sorted)
    pliant_unit_folder(${source})
    file(SIZE ${source} bytes)
    math(EXPR filled "${filled} + ${bytes}")
    if(NOT folder STREQUAL before)
      set(number 1)
      set(filled ${bytes})
    elseif(filled GREATER most)
      math(EXPR number "${number} + 1")
      set(filled ${bytes})
    endif()
    set(before ${folder})
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${number})
  endforeach()
endfunction()
