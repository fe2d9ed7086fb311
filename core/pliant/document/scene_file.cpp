#include <pliant/document/scene_json.h>
#include <pliant/text/stored_file.h>
#include <pliant/text/texts.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace pliant {
namespace {

using Written = SceneJson;

Written json_vector(const Vec<3>& v) { return Written::array({v[0], v[1], v[2]}); }
Written json_range(const Interval& range) { return Written::array({range.min, range.max}); }

Written json_file(const StoredFile& file) { return {{"path", file.path}, {"sha256", file.sha256}}; }

// Files in the folder, or below it, are named from there, so that it can be given away as a whole.
void name_files_from(const std::filesystem::path& folder, Written& part) {
    if (!part.is_structured()) return;
    if (part.is_object() && part.size() == 2 && part.contains("path") && part.contains("sha256")) {
        const std::filesystem::path path(part["path"].get<std::string>());
        if (!path.is_absolute()) return;
        const std::filesystem::path near = path.lexically_relative(folder);
        if (!near.empty() && *near.begin() != "..") part["path"] = near.string();
        return;
    }
    for (Written& inner : part) name_files_from(folder, inner);
}

Written json_assignments(const Lesson& lesson, const Runner::Assignments& assignments) {
    Written object = Written::object();
    for (const auto& [key, text] : assignments) {
        const Parameter& p = lesson.parameter(key);
        const Real value = p.parse(text);
        if (p.info.kind == Kind::choice)
            object[std::string(p.info.key)] = text;
        else if (p.info.kind == Kind::toggle)
            object[std::string(p.info.key)] = value != 0;
        else if (p.info.kind == Kind::whole)
            object[std::string(p.info.key)] = static_cast<long long>(value);
        else if (p.info.kind == Kind::file)
            object[std::string(p.info.key)] = json_file(stored_file(static_cast<Index>(value)));
        else
            object[std::string(p.info.key)] = value;
    }
    return object;
}

void put_changes(Written& object, const Lesson& lesson, const SceneChanges& done) {
    if (!done.set.empty()) object["set"] = json_assignments(lesson, done.set);
    if (done.pull)
        object["pull"] = {
            {"index", done.pull->index}, {"from", json_vector(done.pull->from)}, {"to", json_vector(done.pull->to)}};
    if (done.release) object["release"] = true;
}

Written json_events(const Lesson& lesson, const std::vector<Event>& events) {
    Written list = Written::array();
    for (const Event& e : events) {
        Written object{{"step", e.step}};
        put_changes(object, lesson, {e.assign, e.pull, e.release});
        list.push_back(std::move(object));
    }
    return list;
}

void put_place(Written& object, const Lesson& lesson, const ScenePlace& place) {
    object["step"] = place.step;
    if (place.passes > 0) object["passes"] = place.passes;
    put_changes(object, lesson, place.changes);
    if (place.fails) object["fails"] = true;
}

// What is at its default is left out.
template <class Value>
void put(Written& object, const char* key, const Value& value, const Value& at_first) {
    if (value != at_first) object[key] = value;
}

Written json_camera(const SceneFile& scene) {
    const Camera& c = *scene.camera;
    if (scene.camera_follows) return {{"yaw", c.yaw}, {"pitch", c.pitch}, {"follows", true}};
    Written j{{"target", json_vector(c.target)}, {"distance", c.distance}, {"yaw", c.yaw}, {"pitch", c.pitch}};
    put(j, "aspect", scene.camera_aspect, Real{0});
    return j;
}

Written json_view(const SceneView& v) {
    const SceneView at_first;
    Written j{{"field", v.field}, {"component", v.component}, {"stage", v.stage}};
    if (v.range) j["range"] = json_range(*v.range);
    put(j, "diverging", v.diverging, false), put(j, "fixed", v.fixed, false);
    if (v.change_range) j["change_range"] = json_range(*v.change_range);
    put(j, "change_diverging", v.change_diverging, false);
    put(j, "arrows", v.arrows, true), put(j, "labels", v.labels, true), put(j, "smooth", v.smooth, true);
    put(j, "patterns", v.patterns, false), put(j, "extreme", v.extreme, false);
    put(j, "compare", v.compare, at_first.compare), put(j, "of_stage", v.of_stage, at_first.of_stage);
    put(j, "swipe", v.swipe, at_first.swipe);
    return j;
}

Written json_beside(const Lesson& lesson, const SceneBeside& b) {
    Written j = Written::object();
    if (!b.set.empty()) j["set"] = json_assignments(lesson, b.set);
    if (b.events) j["events"] = json_events(lesson, *b.events);
    if (!b.changes.empty()) put_changes(j["now"] = Written::object(), lesson, b.changes);
    put(j, "addressed", b.addressed, false), put(j, "difference", b.difference, false);
    return j;
}

Written json_pinned(const Lesson& lesson, const ScenePinned& p) {
    Written j = Written::object();
    if (!p.run.parameters.empty()) j["parameters"] = json_assignments(lesson, p.run.parameters);
    if (!p.run.events.empty()) j["events"] = json_events(lesson, p.run.events);
    put_place(j, lesson, p.run.place);
    put(j, "field", p.field, std::string()), put(j, "component", p.component, -1);
    return j;
}

Written json_stops(const SceneStops& s) {
    Written j = Written::object();
    const std::vector<std::string> none;
    put(j, "stages", s.stages, none), put(j, "passes", s.passes, none), put(j, "conditions", s.conditions, none);
    put(j, "assumptions", s.assumptions, false), put(j, "laws", s.laws, false);
    return j;
}

Written json_numbers(const std::vector<SceneNumber>& numbers) {
    Written list = Written::array();
    for (const SceneNumber& n : numbers) {
        Written j{{"field", n.field}, {"index", n.index}};
        put(j, "component", n.component, -1), put(j, "from", n.from, Index{0});
        if (n.when) j["step"] = n.when->step, j["passes"] = n.when->passes;
        list.push_back(std::move(j));
    }
    return list;
}

Written json_inspector(const SceneInspector& in) {
    Written j = Written::object();
    if (!in.on.empty()) j["on"] = in.on;
    put(j, "index", in.index, Index{0});
    if (!in.asked.empty()) j["asked"] = json_numbers(in.asked);
    if (!in.pinned.empty()) j["pinned"] = json_numbers(in.pinned);
    return j;
}

Written json_guess(const Guess& g) {
    Written j = Written::object();
    if (g.option) j["option"] = *g.option + 1;
    if (g.number) j["number"] = *g.number;
    if (!g.sketch.empty()) j["sketch"] = g.sketch;
    put(j, "words", g.words, std::string());
    if (g.was_right) j["right"] = *g.was_right;
    put(j, "after_answer", g.after_answer, false);
    return j;
}

Written json_slide(const SceneSlide& s) {
    Written j{{"number", s.number}};
    put(j, "extension", s.extension, std::size_t{0});
    put(j, "revealed", s.revealed, false), put(j, "unlocked", s.unlocked, false);
    put(j, "lecture", s.lecture, std::string());
    if (s.predicted.given()) j["predicted"] = json_guess(s.predicted);
    return j;
}

Written json_layout(const SceneLayout& l) {
    const SceneLayout at_first;
    Written j = Written::object();
    put(j, "layout", l.layout, at_first.layout), put(j, "tab", l.tab, at_first.tab), put(j, "claim", l.claim, at_first.claim);
    put(j, "fill", l.fill, at_first.fill);
    return j;
}

Written json_plots(const ScenePlots& all) {
    const ScenePlots at_first;
    Written j = Written::object();
    if (all.shown) j["shown"] = *all.shown;
    for (const ScenePlot& p : all.plots) {
        Written& plot = j["plots"][p.name] = Written::object();
        if (p.x) plot["x"] = json_range(*p.x);
        if (p.y) plot["y"] = json_range(*p.y);
        if (p.x_log) plot["x_log"] = *p.x_log;
        if (p.y_log) plot["y_log"] = *p.y_log;
        if (!p.hidden.empty()) plot["hidden"] = p.hidden;
    }
    put(j, "cost", all.cost, false), put(j, "axis", all.axis, 0), put(j, "across", all.across, at_first.across);
    return j;
}

Written json_knob(const SceneKnob& k) {
    Written j{{"key", k.key}};
    if (k.range) j["range"] = json_range(*k.range);
    put(j, "log", k.log, false);
    return j;
}

Written json_atlas(const SceneAtlas& a) {
    Written j{{"across", json_knob(a.across)}, {"up", json_knob(a.up)}};
    if (a.cells) j["cells"] = *a.cells;
    if (a.steps) j["steps"] = *a.steps;
    return j;
}

Written json_scene(const SceneFile& scene) {
    const auto lesson = find_lesson(scene.lesson).make();
    Written root{
        {"pliant", scene.version()}, {"lesson", scene.lesson}, {"parameters", json_assignments(*lesson, scene.parameters)}};
    if (scene.camera) root["camera"] = json_camera(scene);
    if (scene.view) root["view"] = json_view(*scene.view);
    if (!scene.events.empty()) root["events"] = json_events(*lesson, scene.events);
    if (scene.place) put_place(root["place"] = Written::object(), *lesson, *scene.place);
    if (scene.beside) root["beside"] = json_beside(*lesson, *scene.beside);
    if (scene.pinned) root["pinned"] = json_pinned(*lesson, *scene.pinned);
    if (!scene.stops.empty()) root["stops"] = json_stops(scene.stops);
    if (!scene.inspector.empty()) root["inspector"] = json_inspector(scene.inspector);
    if (scene.slide) root["slide"] = json_slide(*scene.slide);
    if (scene.layout) root["layout"] = json_layout(*scene.layout);
    if (!scene.plots.empty()) root["plots"] = json_plots(scene.plots);
    if (scene.atlas) root["atlas"] = json_atlas(*scene.atlas);
    return root;
}

}  // namespace

int SceneFile::version() const {
    const bool looks = view && *view != SceneView{.field = view->field, .component = view->component, .stage = view->stage};
    const bool more = camera_follows || camera_aspect != 0 || looks || place || beside || pinned || slide || layout || atlas ||
                      !stops.empty() || !inspector.empty() || !plots.empty();
    return more ? 2 : 1;
}

std::string scene_text(const SceneFile& scene) { return json_scene(scene).dump(2) + "\n"; }

std::string scene_text_for(const SceneFile& scene, const std::string& path) {
    Written json = json_scene(scene);
    std::error_code error;
    name_files_from(std::filesystem::absolute(path, error).lexically_normal().parent_path(), json);
    return json.dump(2) + "\n";
}

std::string compact_scene_text(const SceneFile& scene) { return json_scene(scene).dump(); }

SceneFile preset(const LessonEntry& entry, std::string_view name) {
    const std::string_view text = preset_text(entry.info.id, name);
    if (text.empty()) {
        const auto known = preset_names(entry.info.id);
        if (known.empty()) throw Refused(fmt::format("{} comes with no presets", entry.info.id));
        throw Refused(fmt::format("{} has no preset '{}'{}; there are: {}", entry.info.id, name, did_you_mean(name, known),
                                  fmt::join(known, ", ")));
    }
    return parse_scene(text, fmt::format("{}/presets/{}.json", entry.info.id, name));
}

}  // namespace pliant
