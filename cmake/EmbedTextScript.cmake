# Run by pliant_embed_text: OUTPUT, ROOT and FILES are given on the command line.
set(entries "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  file(RELATIVE_PATH name ${ROOT} ${file})
  # A raw string literal may hold 64 KiB on every compiler; walkthroughs and scenes are far smaller.
  string(APPEND entries "    {\"${name}\", R\"~~~~(${text})~~~~\"},\n")
endforeach()
file(WRITE ${OUTPUT}
  "#include <pliant/lesson/texts.h>\n\nnamespace {\nconst pliant::TextRegistration texts{{\n${entries}}};\n}\n")
