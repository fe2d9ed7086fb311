# pliant_embed_text(OUTPUT FILES...) writes a C++ source that holds the text of each file under its path
# relative to the calling folder. It is made again when a file changes.
function(pliant_embed_text output)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedTextScript.cmake)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DROOT=${CMAKE_CURRENT_SOURCE_DIR} "-DFILES=${ARGN}" -P ${script}
    DEPENDS ${ARGN} ${script}
    COMMENT "Embedding lesson texts"
    VERBATIM)
endfunction()
