# Run by pliant_embed: OUTPUT, ROOT, KIND and FILES are given on the command line.
set(entries "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  file(RELATIVE_PATH name ${ROOT} ${file})
  # A raw string literal may hold 64 KiB on every compiler, and more on those that Pliant is built with: bodies are larger.
  string(APPEND entries "    {\"${name}\", R\"~~~~(${text})~~~~\"},\n")
endforeach()
if(KIND STREQUAL "assets")
  set(source "#include \"render/assets.h\"

namespace pliant::viewer {

std::string_view asset(std::string_view path) {
    struct Asset {
        std::string_view path, text;
    };
    static constexpr Asset assets[] = {
${entries}    };
    for (const Asset& a : assets)
        if (a.path == path) return a.text;
    return {};
}

}  // namespace pliant::viewer
")
else()
  set(source "#include <pliant/text/texts.h>\n\nnamespace {\nconst pliant::TextRegistration texts{{\n${entries}}};\n}\n")
endif()
file(WRITE ${OUTPUT} "${source}")
