// Functions found in sources of C++.
#include <pliant/math/error.h>
#include <pliant/text/source_code.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr std::string_view source = R"source(// A source.
#include <pliant/fluids/grid.h>

namespace pliant {
namespace {

int twice(int a) { return 2 * a; }

}  // namespace

void called();

// What it is for,
// in two lines.
template <int Dim>
void Grid<Dim>::fill(const char* text, int count) const {
    called();
    if (twice(count) > 3) {
        const char* brace = "}";  // and }
        use(brace, '}', R"(})");
    }
}

Grid::Grid(int n) : size_(n), cells_{n, n} {
    fill("", n);
}

auto Grid::area() -> double {
    return 1;
}

void Grid::put(int a) { put(a, 0); }

void Grid::put(int a, int b) {
    data_[a] = b;
}

#define MACRO(x) ghost(x) {}

class Inner {
public:
    // Of a member.
    int member() const {
        return 1;
    }
};

}  // namespace pliant
)source";

CodeExcerpt found(std::string_view function) { return definition_in(source, function, "grid.cpp"); }

}  // namespace

TEST_CASE("source code: a definition is found with its remarks and its template line, not a call or a declaration") {
    const CodeExcerpt fill = found("fill");
    CHECK(fill.first_line == 13);
    CHECK(fill.lines == 10);
    CHECK(fill.text.starts_with("// What it is for,\n// in two lines.\ntemplate <int Dim>\nvoid Grid<Dim>::fill("));
    CHECK(fill.text.ends_with("    }\n}\n"));
    CHECK(found("twice").text == "int twice(int a) { return 2 * a; }\n");
    CHECK(found("Grid::area").text == "auto Grid::area() -> double {\n    return 1;\n}\n");
    CHECK(found("Grid").text == "Grid::Grid(int n) : size_(n), cells_{n, n} {\n    fill(\"\", n);\n}\n");
}

TEST_CASE("source code: of several definitions the longest, and members are moved to the left") {
    CHECK(found("put").text == "void Grid::put(int a, int b) {\n    data_[a] = b;\n}\n");
    CHECK(found("member").text == "// Of a member.\nint member() const {\n    return 1;\n}\n");
}

TEST_CASE("source code: what is not defined is refused with the file") {
    for (const char* name : {"called", "use", "fil", "ill", "brace", "ghost", "size_", "cells_", "Inner", "namespace"}) {
        INFO(name);
        CHECK_THROWS_WITH(found(name), ContainsSubstring("grid.cpp defines no function '" + std::string(name) + "'"));
    }
    CHECK_THROWS_AS(definition_in("", "f", "x.cpp"), Refused);
    CHECK_THROWS_AS(definition_in("void f() {", "f", "x.cpp"), Refused);
    CHECK_THROWS_AS(definition_in("void f(", "f", "x.cpp"), Refused);
}

TEST_CASE("source code: an excerpt is cut behind so many lines, and says how many are missing") {
    const CodeExcerpt fill = found("fill");
    CHECK(first_lines(fill, 10) == fill.text);
    CHECK(first_lines(fill, 2) == "// What it is for,\n// in two lines.\n// … 8 more lines\n");
}

TEST_CASE("source code: places are read from one text") {
    const auto places = code_places("core/a.cpp: f, G::g; core/b.h: h");
    REQUIRE(places.size() == 3);
    CHECK(places[0].file == "core/a.cpp");
    CHECK(places[0].function == "f");
    CHECK(places[1].file == "core/a.cpp");
    CHECK(places[1].function == "G::g");
    CHECK(places[2].file == "core/b.h");
    CHECK(places[2].function == "h");
    for (const char* wrong : {"", "core/a.cpp", "core/a.cpp:", "core/a.cpp: ", ": f", "core/a.cpp: f,", "core/a.cpp: f;"})
        CHECK_THROWS_WITH(code_places(wrong), ContainsSubstring("names no code"));
}
