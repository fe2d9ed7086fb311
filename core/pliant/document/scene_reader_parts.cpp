// What version 2 of a scene has: where the run stands, what stands beside it, and how it is looked at.
#include <pliant/document/scene_json.h>
#include <pliant/run/breakpoints.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pliant {
namespace {

constexpr Index largest_index = 1'000'000'000'000'000;
constexpr std::array kinds_of_things{On::node,     On::edge,   On::face,   On::cell,  On::element,
                                     On::particle, On::x_face, On::y_face, On::handle};

}  // namespace

void SceneReader::take_parts(const SceneJson& root, SceneFile& scene) const {
    const auto has = [&](const char* key) { return root.contains(key); };
    if (has("place")) {
        known_keys(root["place"], "/place", {"step", "passes", "set", "pull", "release", "fails"});
        scene.place = place(root["place"], "/place");
    }
    if (has("beside")) scene.beside = beside(root["beside"]);
    if (has("pinned")) scene.pinned = pinned(root["pinned"]);
    if (has("stops")) scene.stops = stops(root["stops"]);
    if (has("inspector")) scene.inspector = inspector(root["inspector"]);
    if (has("slide")) scene.slide = slide(root["slide"]);
    if (has("layout")) scene.layout = layout(root["layout"], scene.inspector.pinned.size());
    if (has("plots")) scene.plots = plots(root["plots"], scene.inspector.pinned.size());
    if (has("atlas")) scene.atlas = atlas(root["atlas"]);
    if (scene.slide && scene.slide->lecture.empty() && scene.beside)
        refuse("/beside", "a slide shows one run: leave out 'slide' or 'beside'");
}

// ------------------------------------------------------------------------------------------------------- single values

void SceneReader::take_flag(const SceneJson& object, const std::string& pointer, const char* key, bool& flag) const {
    if (!object.contains(key)) return;
    if (!object[key].is_boolean()) refuse(fmt::format("{}/{}", pointer, key), fmt::format("'{}' is true or false", key));
    flag = object[key].get<bool>();
}

void SceneReader::take_whole(const SceneJson& object, const std::string& pointer, const char* key, Index least, Index most,
                             Index& number) const {
    if (object.contains(key)) number = whole_at(object[key], fmt::format("{}/{}", pointer, key), key, least, most);
}

void SceneReader::take_name(const SceneJson& object, const std::string& pointer, const char* key,
                            std::span<const std::string_view> known, std::string& name) const {
    if (!object.contains(key)) return;
    const std::string here = fmt::format("{}/{}", pointer, key);
    name = text_at(object, key, here);
    const std::vector<std::string> names(known.begin(), known.end());
    if (std::ranges::find(names, name) == names.end())
        refuse(here, fmt::format("'{}' is not accepted for '{}'{}; there are: {}", name, key, did_you_mean(name, names),
                                 fmt::join(names, ", ")));
}

std::optional<Interval> SceneReader::range_at(const SceneJson& object, const std::string& pointer, const char* key) const {
    if (!object.contains(key)) return std::nullopt;
    const std::string here = fmt::format("{}/{}", pointer, key);
    const SceneJson& v = object[key];
    if (!v.is_array() || v.size() != 2)
        refuse(here, fmt::format("'{}' is two numbers in brackets, the lower one first, not {}", key, v.dump()));
    const Interval range{number_at(v[0], here, key), number_at(v[1], here, key)};
    if (!(range.min <= range.max)) refuse(here, fmt::format("the first number of '{}' is the lower one", key));
    return range;
}

std::vector<std::string> SceneReader::texts_at(const SceneJson& object, const std::string& pointer, const char* key) const {
    std::vector<std::string> texts;
    if (!object.contains(key)) return texts;
    const std::string here = fmt::format("{}/{}", pointer, key);
    const SceneJson& list = object[key];
    if (!list.is_array()) refuse(here, fmt::format("'{}' is a list in brackets", key));
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!list[i].is_string())
            refuse(fmt::format("{}/{}", here, i), fmt::format("'{}' holds texts in quotes, not {}", key, list[i].dump()));
        texts.push_back(list[i].get<std::string>());
    }
    return texts;
}

// --------------------------------------------------------------------------------------------------------------- runs

SceneChanges SceneReader::changes(const SceneJson& object, const std::string& pointer) const {
    SceneChanges done;
    if (object.contains("set")) done.set = assignments(object["set"], pointer + "/set");
    if (object.contains("pull")) done.pull = pull(object["pull"], pointer + "/pull");
    take_flag(object, pointer, "release", done.release);
    return done;
}

SceneChanges SceneReader::changes_now(const SceneJson& object, const std::string& pointer) const {
    SceneChanges done = changes(object, pointer);
    for (const auto& [key, text] : done.set)
        if (lesson_->parameter(key).info.effect == Effect::rebuild)
            refuse(pointer + "/set/" + pointer_part(key),
                   fmt::format("'{}' begins the run anew: set it among the parameters at the start", key));
    return done;
}

ScenePlace SceneReader::place(const SceneJson& object, const std::string& pointer) const {
    ScenePlace p;
    take_whole(object, pointer, "step", 0, ScenePlace::most_steps, p.step);
    take_whole(object, pointer, "passes", 0, ScenePlace::most_passes, p.passes);
    take_flag(object, pointer, "fails", p.fails);
    p.changes = changes_now(object, pointer);
    return p;
}

SceneBeside SceneReader::beside(const SceneJson& object) const {
    known_keys(object, "/beside", {"set", "events", "now", "addressed", "difference"});
    SceneBeside b;
    if (object.contains("set")) b.set = assignments(object["set"], "/beside/set");
    if (object.contains("events")) b.events = events(object["events"], "/beside/events");
    if (object.contains("now")) {
        known_keys(object["now"], "/beside/now", {"set", "pull", "release"});
        b.changes = changes_now(object["now"], "/beside/now");
    }
    take_flag(object, "/beside", "addressed", b.addressed);
    take_flag(object, "/beside", "difference", b.difference);
    return b;
}

ScenePinned SceneReader::pinned(const SceneJson& object) const {
    known_keys(object, "/pinned", {"parameters", "events", "step", "passes", "set", "pull", "release", "field", "component"});
    ScenePinned p;
    if (object.contains("parameters")) p.run.parameters = assignments(object["parameters"], "/pinned/parameters");
    if (object.contains("events")) p.run.events = events(object["events"], "/pinned/events");
    p.run.place = place(object, "/pinned");
    p.field = field(object, "/pinned");
    p.component = component(object, "/pinned", p.field);
    return p;
}

// ------------------------------------------------------------------------------------------------------ what is shown

void SceneReader::take_look(const SceneJson& object, SceneView& v) const {
    v.range = range_at(object, "/view", "range");
    v.change_range = range_at(object, "/view", "change_range");
    take_flag(object, "/view", "diverging", v.diverging);
    take_flag(object, "/view", "change_diverging", v.change_diverging);
    take_flag(object, "/view", "fixed", v.fixed);
    take_flag(object, "/view", "arrows", v.arrows);
    take_flag(object, "/view", "labels", v.labels);
    take_flag(object, "/view", "smooth", v.smooth);
    take_flag(object, "/view", "patterns", v.patterns);
    take_flag(object, "/view", "extreme", v.extreme);
    take_name(object, "/view", "compare", scene_comparisons, v.compare);
    if (object.contains("of_stage")) v.of_stage = stage(text_at(object, "of_stage", "/view/of_stage"), "/view/of_stage");
    if (!object.contains("swipe")) return;
    v.swipe = number_at(object["swipe"], "/view/swipe", "swipe");
    if (v.swipe < 0 || v.swipe > 1) refuse("/view/swipe", "'swipe' is where its line is, from 0 to 1 of the picture's width");
}

SceneStops SceneReader::stops(const SceneJson& object) const {
    known_keys(object, "/stops", {"stages", "passes", "conditions", "assumptions", "laws"});
    SceneStops s;
    for (const auto& [key, list] : {std::pair{"stages", &s.stages}, {"passes", &s.passes}}) {
        *list = texts_at(object, "/stops", key);
        for (std::size_t i = 0; i < list->size(); ++i) stage((*list)[i], fmt::format("/stops/{}/{}", key, i));
    }
    s.conditions = texts_at(object, "/stops", "conditions");
    for (std::size_t i = 0; i < s.conditions.size(); ++i)
        checked(fmt::format("/stops/conditions/{}", i),
                [&] { s.conditions[i] = parse_condition(s.conditions[i], *lesson_).text(); });
    take_flag(object, "/stops", "assumptions", s.assumptions);
    take_flag(object, "/stops", "laws", s.laws);
    return s;
}

SceneInspector SceneReader::inspector(const SceneJson& object) const {
    known_keys(object, "/inspector", {"on", "index", "asked", "pinned"});
    SceneInspector in;
    std::vector<std::string_view> known;
    for (const On on : kinds_of_things) known.push_back(name_of(on));
    take_name(object, "/inspector", "on", known, in.on);
    take_whole(object, "/inspector", "index", 0, largest_index, in.index);
    if (object.contains("asked")) in.asked = numbers(object["asked"], "/inspector/asked", false);
    if (object.contains("pinned")) in.pinned = numbers(object["pinned"], "/inspector/pinned", true);
    return in;
}

std::vector<SceneNumber> SceneReader::numbers(const SceneJson& list, const std::string& pointer, bool followed) const {
    if (!list.is_array()) refuse(pointer, "numbers of the run are a list in brackets: [{\"field\": ..., \"index\": 0}]");
    std::vector<SceneNumber> all;
    for (std::size_t i = 0; i < list.size(); ++i) all.push_back(number(list[i], fmt::format("{}/{}", pointer, i), followed));
    return all;
}

SceneNumber SceneReader::number(const SceneJson& object, const std::string& pointer, bool followed) const {
    known_keys(object, pointer,
               followed ? std::vector<std::string>{"field", "index", "component", "from"}
                        : std::vector<std::string>{"field", "index", "component", "step", "passes"});
    SceneNumber n;
    if (!object.contains("field")) refuse(pointer, "a number of the run needs a 'field', or the name of a probe");
    n.field = text_at(object, "field", pointer + "/field");
    const std::string_view name = n.field.starts_with("probe:") ? std::string_view(n.field).substr(6) : std::string_view(n.field);
    const bool is_probe = std::ranges::find(lesson_->probes, name, &Probe::name) != lesson_->probes.end();
    if (followed || !is_probe) n.field = field(object, pointer);
    n.component = component(object, pointer, n.field);
    take_whole(object, pointer, "index", 0, largest_index, n.index);
    take_whole(object, pointer, "from", 0, ScenePlace::most_steps, n.from);
    if (!object.contains("step")) return n;
    Place when;
    take_whole(object, pointer, "step", 0, ScenePlace::most_steps, when.step);
    take_whole(object, pointer, "passes", 0, ScenePlace::most_passes, when.passes);
    n.when = when;
    return n;
}

SceneSlide SceneReader::slide(const SceneJson& object) const {
    known_keys(object, "/slide", {"number", "extension", "revealed", "unlocked", "lecture", "predicted"});
    constexpr Index most = 1000;
    Index number = 1, extension = 0;
    take_whole(object, "/slide", "number", 1, most, number);
    take_whole(object, "/slide", "extension", 0, most, extension);
    SceneSlide s{.number = static_cast<std::size_t>(number), .extension = static_cast<std::size_t>(extension)};
    take_flag(object, "/slide", "revealed", s.revealed);
    take_flag(object, "/slide", "unlocked", s.unlocked);
    if (object.contains("lecture")) s.lecture = text_at(object, "lecture", "/slide/lecture");
    if (object.contains("predicted")) s.predicted = guess(object["predicted"], "/slide/predicted");
    return s;
}

// Whether the slide asks for it is seen when it is shown.
Guess SceneReader::guess(const SceneJson& object, const std::string& pointer) const {
    known_keys(object, pointer, {"option", "number", "sketch", "words", "right", "after_answer"});
    const auto here = [&](const char* key) { return fmt::format("{}/{}", pointer, key); };
    Guess g;
    if (object.contains("option"))
        g.option = static_cast<std::size_t>(whole_at(object["option"], here("option"), "option", 1, 9)) - 1;
    if (object.contains("number")) g.number = number_at(object["number"], here("number"), "number");
    if (object.contains("sketch")) {
        const SceneJson& list = object["sketch"];
        if (!list.is_array() || list.size() < 2 || list.size() > sketch_points)
            refuse(here("sketch"), fmt::format("'sketch' is a list of 2 to {} numbers", sketch_points));
        std::vector<Real> values;
        for (std::size_t k = 0; k < list.size(); ++k)
            values.push_back(number_at(list[k], fmt::format("{}/{}", here("sketch"), k), "sketch"));
        g.sketch = sketch_through(values);
    }
    if (object.contains("words")) g.words = text_at(object, "words", here("words"));
    if (object.contains("right")) take_flag(object, pointer, "right", g.was_right.emplace());
    take_flag(object, pointer, "after_answer", g.after_answer);
    if (g.was_right && g.words.empty()) refuse(here("right"), "'right' is said of 'words'");
    return g;
}

SceneLayout SceneReader::layout(const SceneJson& object, std::size_t followed) const {
    known_keys(object, "/layout", {"layout", "tab", "claim", "fill"});
    SceneLayout l;
    take_name(object, "/layout", "layout", scene_layouts, l.layout);
    take_name(object, "/layout", "tab", scene_tabs, l.tab);
    if (object.contains("claim")) l.claim = text_at(object, "claim", "/layout/claim");
    if (!object.contains("fill")) return l;
    l.fill = text_at(object, "fill", "/layout/fill");
    constexpr std::string_view plot = "plot ";
    if (l.fill.starts_with(plot) && l.fill != "plot cost")
        return check_plot(l.fill.substr(plot.size()), "/layout/fill", followed), l;
    constexpr std::array<std::string_view, 4> fills{"picture", "matrix", "atlas", "plot cost"};
    take_name(object, "/layout", "fill", fills, l.fill);
    return l;
}

}  // namespace pliant
