// What each fuzzer does with its bytes. Anything but pliant::Error that comes out of here is a fault, and so is a promise of the
// reader that is not kept.
#pragma once
#include <pliant/document/share.h>
#include <pliant/document/walkthrough.h>
#include <pliant/formula/formula.h>
#include <pliant/lecture/lecture.h>
#include <pliant/mesh_file/mesh_file.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::test {

inline void promise(bool kept, const char* what) {
    if (!kept) throw std::logic_error(what);
}

// True when the bytes were accepted.
inline bool fuzz_scene_file(std::string_view bytes) {
    SceneFile scene;
    try {
        scene = parse_scene(bytes, "scene.json");
    } catch (const Error&) {
        return false;
    }
    const std::string text = scene_text(scene);
    promise(scene_text(parse_scene(text, "again.json")) == text,
            "a scene that was read is written so that it reads back the same");
    return true;
}

inline bool fuzz_share_string(std::string_view bytes) {
    SceneFile scene;
    try {
        scene = read_share(bytes);
    } catch (const Error&) {
        return false;
    }
    promise(is_share(share_text(scene)), "a share string begins as one");
    promise(scene_text(read_share(share_text(scene))) == scene_text(scene), "a shared scene reads back the same");
    return true;
}

inline bool fuzz_walkthrough(std::string_view bytes) {
    try {
        promise(!parse_walkthrough(bytes, "walkthrough.md").slides.empty(), "a walkthrough has slides");
    } catch (const Error&) {
        return false;
    }
    return true;
}

// True when every slide can be shown.
inline bool fuzz_lecture(std::string_view bytes) {
    try {
        const Lecture lecture = parse_lecture(bytes, "lecture");
        promise(!lecture.slides.empty(), "a lecture has slides");
        bool whole = true;
        for (const LectureSlide& s : lecture.slides) {
            promise(!s.slide.title.empty(), "a slide has a title");
            whole = whole && s.trouble.empty();
        }
        handout_html(lecture, {});
        return whole;
    } catch (const Error&) {
        return false;
    }
}

// The ending that a mesh file with these first bytes has.
inline std::string mesh_name(std::string_view bytes) {
    if (bytes.starts_with("$")) return "body.msh";
    if (bytes.starts_with("# vtk")) return "body.vtk";
    if (bytes.starts_with("<")) return "body.vtu";
    for (const char* begin : {"# ", "v ", "o ", "g ", "f "})
        if (bytes.starts_with(begin)) return "body.obj";
    return "body.stl";
}

// True when it makes a body, or a surface.
inline bool fuzz_mesh_file(std::string_view bytes) {
    const auto promise_body = [](const auto& mesh) {
        promise(mesh.volume() > 0, "a body has a volume");
        promise(mesh.facet_count() > 0, "a body has a boundary");
    };
    try {
        const std::string name = mesh_name(bytes);
        const MeshFile file = parse_mesh_file(bytes, name);
        if (name == "body.obj" || name == "body.stl")
            return promise(surface_of(file, name).triangles.cols() > 0, "a surface"), true;
        if (file.dimension() == 3) return promise_body(simplex_mesh_of<3>(file, name)), true;
        if (file.dimension() == 2) return promise_body(simplex_mesh_of<2>(file, name)), true;
    } catch (const Error&) {
    }
    return false;
}

// A formula of some symbols, a family and a function.
inline bool fuzz_formula(std::string_view bytes) {
    const std::vector<FormulaSymbol> symbols{{"x", Unit("m")}, {"x_i", Unit("m"), true}, {"a", Unit()}, {"ε̄", Unit()}};
    const std::vector<Real> many{1, -2, 3};
    const Real one = 0.5;
    const std::vector<FormulaNumbers> numbers{{&one}, {many.data(), many.size()}, {&one}, {&one}};
    try {
        const Formula f(std::string(bytes), symbols, {{"f", Unit(), [](std::span<const Real> v) { return v[0]; }}});
        std::string text(bytes), kept = std::string(f.left()) + std::string(f.right()) + std::string(f.remark());
        std::erase(text, ' '), std::erase(kept, ' ');
        if (const std::size_t equals = text.find('='); equals != text.npos) text.erase(equals, 1);
        promise(kept == text, "both sides and the remark are all of the text");
        promise(f.gradient(numbers).size() == 6, "every number has a slope");
        promise(!f.with_numbers(numbers, std::vector<std::string>{"m", "m", "", ""}).empty(), "numbers are put in");
        promise(!f.latex().empty(), "it is written in LaTeX");
        f.check_units();
    } catch (const BadFormula& e) {
        promise(std::string_view(e.what()).find("cannot be read at letter") != std::string_view::npos, "the place is told");
        return false;
    }
    return true;
}

}  // namespace pliant::test
