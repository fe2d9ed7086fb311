# Texts that are read, not compiled, become part of the program. They are embedded again when a file changes.

# pliant_embed_text(OUTPUT FILES...) writes a C++ source that registers the text of each file (pliant/text/texts.h) under its
# path relative to the calling folder.
function(pliant_embed_text output)
  pliant_embed(${output} ${CMAKE_CURRENT_SOURCE_DIR} lessons ${ARGN})
endfunction()

# pliant_embed_assets(OUTPUT FILES...) writes the one that defines pliant::viewer::asset(path), with paths relative to assets/.
function(pliant_embed_assets output)
  pliant_embed(${output} ${PROJECT_SOURCE_DIR}/assets assets ${ARGN})
endfunction()

function(pliant_embed output root kind)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedTextScript.cmake)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DROOT=${root} -DKIND=${kind} "-DFILES=${ARGN}" -P ${script}
    DEPENDS ${ARGN} ${script}
    COMMENT "Embedding the texts of ${kind}"
    VERBATIM)
endfunction()
