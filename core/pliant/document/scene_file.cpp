#include <pliant/document/scene_file.h>
#include <pliant/text/file.h>
#include <pliant/text/json_positions.h>
#include <pliant/text/suggest.h>
#include <pliant/text/texts.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;
constexpr int version = 1;

// Walks the JSON of a scene and refuses what does not belong, with its place.
class SceneReader {
public:
    SceneReader(std::string_view text, std::string_view path) : path_(path), json_(parse_json(text, path)) {}

    SceneFile read() {
        const Json& root = json_.value;
        if (!root.is_object())
            refuse("", "a scene file is one JSON object: {\"pliant\": 1, \"lesson\": ..., \"parameters\": {...}}");
        check_version(root);
        known_keys(root, "", {"pliant", "lesson", "parameters", "camera", "view", "events"});
        SceneFile scene;
        if (!root.contains("lesson")) refuse("", "the key \"lesson\" is missing: name a lesson such as \"mesh/mass_spring\"");
        const LessonEntry* entry = nullptr;
        const std::string name = text_at(root, "lesson", "/lesson");
        checked("/lesson", [&] { entry = &find_lesson(name); });
        scene.lesson = entry->info.id;
        lesson_ = entry->make();
        if (root.contains("parameters")) scene.parameters = assignments(root["parameters"], "/parameters");
        if (root.contains("camera")) scene.camera = camera(root["camera"]);
        if (root.contains("view")) scene.view = view(root["view"]);
        if (root.contains("events")) scene.events = events(root["events"]);
        return scene;
    }

private:
    [[noreturn]] void refuse(const std::string& pointer, const std::string& what) const {
        const TextPlace p = json_.at(pointer);
        throw Refused(fmt::format("{}:{}:{}: {}", path_, p.line, p.column, what));
    }
    // Adds the place to an error that the lesson raises.
    template <class Check>
    void checked(const std::string& pointer, Check check) const {
        try {
            check();
        } catch (const Refused& e) {
            refuse(pointer, e.what());
        }
    }

    void check_version(const Json& root) const {
        if (!root.contains("pliant")) refuse("", "the key \"pliant\" is missing: a scene file begins with {\"pliant\": 1, ...}");
        const Json& v = root["pliant"];
        if (!v.is_number_integer() || v.get<long long>() < 1)
            refuse("/pliant", "\"pliant\" is the version of the format: give 1");
        if (v.get<long long>() > version)
            refuse("/pliant",
                   fmt::format("this scene is of version {}, newer than this program, which reads version {}: update Pliant",
                               v.dump(), version));
    }

    void known_keys(const Json& object, const std::string& pointer, const std::vector<std::string>& known) const {
        if (!object.is_object()) refuse(pointer, fmt::format("an object in braces is expected here, not {}", object.type_name()));
        for (const auto& [key, value] : object.items())
            if (std::ranges::find(known, key) == known.end())
                refuse(pointer + "/" + pointer_part(key),
                       fmt::format("unknown key '{}'{}; known here: {}", key, did_you_mean(key, known), fmt::join(known, ", ")));
    }

    std::string text_at(const Json& object, const std::string& key, const std::string& pointer) const {
        const Json& v = object[key];
        if (!v.is_string()) refuse(pointer, fmt::format("'{}' is a text in quotes, not {}", key, v.dump()));
        return v.get<std::string>();
    }

    Real number_at(const Json& v, const std::string& pointer, const std::string& name) const {
        if (!v.is_number() || !std::isfinite(v.get<Real>()))
            refuse(pointer, fmt::format("'{}' is a finite number, not {}", name, v.dump()));
        return v.get<Real>();
    }

    Index whole_at(const Json& v, const std::string& pointer, const std::string& name, Index least) const {
        const Real value = number_at(v, pointer, name);
        if (value < static_cast<Real>(least) || value != std::floor(value) || value > 1e15)
            refuse(pointer, fmt::format("'{}' is a whole number from {} on, not {}", name, least, v.dump()));
        return static_cast<Index>(value);
    }

    Runner::Assignments assignments(const Json& object, const std::string& pointer) const {
        if (!object.is_object()) refuse(pointer, "parameters are an object of keys and values: {\"key\": value}");
        Runner::Assignments result;
        for (const auto& [key, value] : object.items()) {
            const std::string here = pointer + "/" + pointer_part(key);
            checked(here, [&, &name = key, &given = value] {
                const Parameter& p = lesson_->parameter(name);
                result.emplace_back(name, parameter_text(p, given));
                p.parse(result.back().second);
            });
        }
        return result;
    }

    // A choice is a string, a switch true or false, a number a number.
    static std::string parameter_text(const Parameter& p, const Json& value) {
        const auto wrong = [&](std::string_view expected) {
            return Refused(fmt::format("{} = {}: {} is expected", p.info.key, value.dump(), expected));
        };
        switch (p.info.kind) {
            case Kind::choice:
                if (!value.is_string()) throw wrong("an option's name in quotes");
                return value.get<std::string>();
            case Kind::toggle:
                if (!value.is_boolean()) throw wrong("true or false");
                return value.get<bool>() ? "true" : "false";
            default:
                if (!value.is_number()) throw wrong("a number");
                return value.dump();
        }
    }

    Vec<3> vector_at(const Json& v, const std::string& pointer, const std::string& name) const {
        if (!v.is_array() || v.size() != 3)
            refuse(pointer, fmt::format("'{}' is three numbers in brackets, not {}", name, v.dump()));
        Vec<3> result;
        for (std::size_t i = 0; i < 3; ++i) result[static_cast<Index>(i)] = number_at(v[i], pointer, name);
        return result;
    }

    Camera camera(const Json& object) const {
        known_keys(object, "/camera", {"target", "distance", "yaw", "pitch"});
        Camera c;
        if (object.contains("target")) c.target = vector_at(object["target"], "/camera/target", "target");
        for (const auto& [key, member] :
             {std::pair{"distance", &Camera::distance}, {"yaw", &Camera::yaw}, {"pitch", &Camera::pitch}})
            if (object.contains(key)) c.*member = number_at(object[key], std::string("/camera/") + key, key);
        if (c.distance <= 0) refuse("/camera/distance", "distance is in metres and above 0");
        return c;
    }

    SceneView view(const Json& object) const {
        known_keys(object, "/view", {"field", "component", "stage"});
        SceneView v;
        if (object.contains("field")) {
            v.field = text_at(object, "field", "/view/field");
            if (!v.field.empty() && !lesson_->find_field(v.field)) checked("/view/field", [&] { lesson_->field(v.field); });
        }
        if (object.contains("stage")) v.stage = stage(text_at(object, "stage", "/view/stage"));
        if (object.contains("component")) {
            const Field* field = lesson_->find_field(v.field);
            const Real component = number_at(object["component"], "/view/component", "component");
            const int count = field ? field->components : 0;
            if (component != std::floor(component) || component < -1 || component >= count)
                refuse("/view/component", fmt::format("component counts from 0 to {}, or is -1 for the whole", count - 1));
            v.component = static_cast<int>(component);
        }
        return v;
    }

    std::string stage(const std::string& name) const {
        std::vector<std::string> known;
        for (const Stage& s : lesson_->stages) known.emplace_back(s.name);
        if (!name.empty() && std::ranges::find(known, name) == known.end())
            refuse("/view/stage", fmt::format("no stage is called '{}'{}; there are: {}", name, did_you_mean(name, known),
                                              fmt::join(known, ", ")));
        return name;
    }

    std::vector<Event> events(const Json& list) const {
        if (!list.is_array()) refuse("/events", "events are a list in brackets");
        std::vector<Event> result;
        for (std::size_t i = 0; i < list.size(); ++i) result.push_back(event(list[i], "/events/" + std::to_string(i)));
        return result;
    }

    Event event(const Json& object, const std::string& pointer) const {
        known_keys(object, pointer, {"step", "set", "pull", "release"});
        Event e;
        if (!object.contains("step")) refuse(pointer, "an event needs a 'step': a whole number from 0 on");
        e.step = whole_at(object["step"], pointer + "/step", "step", 0);
        if (object.contains("set")) e.assign = assignments(object["set"], pointer + "/set");
        if (object.contains("pull")) e.pull = pull(object["pull"], pointer + "/pull");
        if (object.contains("release")) {
            if (!object["release"].is_boolean()) refuse(pointer + "/release", "'release' is true or false");
            e.release = object["release"].get<bool>();
        }
        return e;
    }

    Pull pull(const Json& object, const std::string& pointer) const {
        known_keys(object, pointer, {"index", "from", "to"});
        Pull p;
        if (object.contains("index")) p.index = whole_at(object["index"], pointer + "/index", "index", -1);
        if (object.contains("from")) p.from = vector_at(object["from"], pointer + "/from", "from");
        if (!object.contains("to")) refuse(pointer, "a pull needs 'to': where the thing is drawn to, three numbers in metres");
        p.to = vector_at(object["to"], pointer + "/to", "to");
        return p;
    }

    std::string path_;
    PlacedJson json_;
    std::unique_ptr<Lesson> lesson_;
};

Json json_vector(const Vec<3>& v) { return Json::array({v[0], v[1], v[2]}); }

Json json_assignments(const Lesson& lesson, const Runner::Assignments& assignments) {
    Json object = Json::object();
    for (const auto& [key, text] : assignments) {
        const Parameter& p = lesson.parameter(key);
        const Real value = p.parse(text);
        if (p.info.kind == Kind::choice)
            object[key] = text;
        else if (p.info.kind == Kind::toggle)
            object[key] = value != 0;
        else if (p.info.kind == Kind::whole)
            object[key] = static_cast<long long>(value);
        else
            object[key] = value;
    }
    return object;
}

Json json_event(const Lesson& lesson, const Event& e) {
    Json object{{"step", e.step}};
    if (!e.assign.empty()) object["set"] = json_assignments(lesson, e.assign);
    if (e.pull) object["pull"] = {{"index", e.pull->index}, {"from", json_vector(e.pull->from)}, {"to", json_vector(e.pull->to)}};
    if (e.release) object["release"] = true;
    return object;
}

}  // namespace

SceneFile parse_scene(std::string_view text, std::string_view path) { return SceneReader(text, path).read(); }

SceneFile read_scene(const std::string& path) { return parse_scene(read_file(path), path); }

namespace {
Json json_scene(const SceneFile& scene) {
    const auto lesson = find_lesson(scene.lesson).make();
    Json root{{"pliant", version}, {"lesson", scene.lesson}, {"parameters", json_assignments(*lesson, scene.parameters)}};
    if (scene.camera) {
        const Camera& c = *scene.camera;
        root["camera"] = {{"target", json_vector(c.target)}, {"distance", c.distance}, {"yaw", c.yaw}, {"pitch", c.pitch}};
    }
    if (scene.view)
        root["view"] = {{"field", scene.view->field}, {"component", scene.view->component}, {"stage", scene.view->stage}};
    for (const Event& e : scene.events) root["events"].push_back(json_event(*lesson, e));
    return root;
}
}  // namespace

std::string scene_text(const SceneFile& scene) { return json_scene(scene).dump(2) + "\n"; }

std::string compact_scene_text(const SceneFile& scene) { return json_scene(scene).dump(); }

SceneFile scene_of(const Runner& runner) {
    SceneFile scene{.lesson = std::string(runner.info().id), .parameters = {}, .events = runner.events()};
    const Recording& played = runner.recording();
    for (const Parameter* p : runner.lesson().parameters)
        if (const Real value = played.start(*p); value != p->info.initial)
            scene.parameters.emplace_back(p->info.key, p->text(value));
    scene.events.insert(scene.events.end(), played.events().begin(), played.events().end());
    std::ranges::stable_sort(scene.events, {}, &Event::step);
    return scene;
}

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
