#include <pliant/document/scene_json.h>
#include <pliant/text/file.h>
#include <pliant/text/stored_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pliant {
namespace {
constexpr int newest_version = 2;
constexpr Index largest_whole = 1'000'000'000'000'000;
}  // namespace

SceneFile SceneReader::read() {
    const SceneJson& root = json_.value;
    if (!root.is_object()) refuse("", "a scene file is one JSON object: {\"pliant\": 1, \"lesson\": ..., \"parameters\": {...}}");
    check_version(root);
    known_keys(root, "",
               {"pliant", "lesson", "parameters", "camera", "view", "events", "place", "beside", "pinned", "stops", "inspector",
                "slide", "layout", "plots", "atlas"},
               6);
    SceneFile scene;
    if (!root.contains("lesson")) refuse("", "the key \"lesson\" is missing: name a lesson such as \"mesh/mass_spring\"");
    const LessonEntry* entry = nullptr;
    const std::string name = text_at(root, "lesson", "/lesson");
    checked("/lesson", [&] { entry = &find_lesson(name); });
    scene.lesson = entry->info.id;
    lesson_ = entry->make();
    if (root.contains("parameters")) scene.parameters = assignments(root["parameters"], "/parameters");
    if (root.contains("camera")) scene.camera = camera(root["camera"], scene);
    if (root.contains("view")) scene.view = view(root["view"]);
    if (root.contains("events")) scene.events = events(root["events"], "/events");
    take_parts(root, scene);
    for (const std::string& note : notes_)
        if (std::ranges::find(scene.notes, note) == scene.notes.end()) scene.notes.push_back(note);
    return scene;
}

void SceneReader::refuse(const std::string& pointer, const std::string& what) const {
    const TextPlace p = json_.at(pointer);
    throw Refused(fmt::format("{}:{}:{}: {}", path_, p.line, p.column, what));
}

void SceneReader::check_version(const SceneJson& root) const {
    if (!root.contains("pliant")) refuse("", "the key \"pliant\" is missing: a scene file begins with {\"pliant\": 1, ...}");
    const SceneJson& v = root["pliant"];
    if (!v.is_number_integer() || v.get<long long>() < 1)
        refuse("/pliant", "\"pliant\" is the version of the format: give 1 or 2");
    if (v.get<long long>() > newest_version)
        refuse("/pliant",
               fmt::format("this scene is of version {}, newer than this program, which reads version {}: update Pliant",
                           v.dump(), newest_version));
}

void SceneReader::known_keys(const SceneJson& object, const std::string& pointer, const std::vector<std::string>& known,
                             std::size_t first) const {
    if (!object.is_object()) refuse(pointer, fmt::format("an object in braces is expected here, not {}", object.type_name()));
    const bool newest = json_.value["pliant"].get<long long>() == newest_version;
    for (const auto& [key, value] : object.items()) {
        const auto found = std::ranges::find(known, key);
        const std::string here = pointer + "/" + pointer_part(key);
        if (found == known.end())
            refuse(here,
                   fmt::format("unknown key '{}'{}; known here: {}", key, did_you_mean(key, known), fmt::join(known, ", ")));
        if (first > 0 && !newest && found - known.begin() >= static_cast<std::ptrdiff_t>(first))
            refuse(here,
                   fmt::format("'{}' is of version {}: begin with {{\"pliant\": {}, ...}}", key, newest_version, newest_version));
    }
}

// ------------------------------------------------------------------------------------------------------- single values

std::string SceneReader::text_at(const SceneJson& object, const std::string& key, const std::string& pointer) const {
    const SceneJson& v = object[key];
    if (!v.is_string()) refuse(pointer, fmt::format("'{}' is a text in quotes, not {}", key, v.dump()));
    return v.get<std::string>();
}

Real SceneReader::number_at(const SceneJson& v, const std::string& pointer, const std::string& name) const {
    if (!v.is_number() || !std::isfinite(v.get<Real>()))
        refuse(pointer, fmt::format("'{}' is a finite number, not {}", name, v.dump()));
    return v.get<Real>();
}

Index SceneReader::whole_at(const SceneJson& v, const std::string& pointer, const std::string& name, Index least,
                            Index most) const {
    const Real value = number_at(v, pointer, name);
    if (value >= static_cast<Real>(least) && value == std::floor(value) && value <= static_cast<Real>(most))
        return static_cast<Index>(value);
    const std::string range =
        most == largest_whole ? fmt::format("from {} on", least) : fmt::format("from {} to {}", least, most);
    refuse(pointer, fmt::format("'{}' is a whole number {}, not {}", name, range, v.dump()));
}

Vec<3> SceneReader::vector_at(const SceneJson& v, const std::string& pointer, const std::string& name) const {
    if (!v.is_array() || v.size() != 3) refuse(pointer, fmt::format("'{}' is three numbers in brackets, not {}", name, v.dump()));
    Vec<3> result;
    for (std::size_t i = 0; i < 3; ++i) result[static_cast<Index>(i)] = number_at(v[i], pointer, name);
    return result;
}

// ------------------------------------------------------------------------------------------- what the lesson declares

// A choice is a string, a switch true or false, a number a number, a file its path, with its hash beside it or without.
std::string SceneReader::parameter_text(const Parameter& p, const SceneJson& value) const {
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
        case Kind::file:
            return file_path(p, value);
        default:
            if (!value.is_number()) throw wrong("a number");
            return value.dump();
    }
}

// From the root on: the scene may be run from elsewhere.
std::string SceneReader::file_path(const Parameter& p, const SceneJson& value) const {
    const auto is_text = [&](const char* key) { return value.contains(key) && value[key].is_string(); };
    const bool with_hash = value.is_object() && value.size() == 2 && is_text("path") && is_text("sha256");
    if (!with_hash && !(value.is_object() && value.size() == 1 && is_text("path")) && !value.is_string())
        throw Refused(fmt::format("{} = {}: {{\"path\": \"...\", \"sha256\": \"...\"}} is expected, or a path in quotes",
                                  p.info.key, value.dump()));
    const auto path = value.is_string() ? value.get<std::string>() : value["path"].get<std::string>();
    const auto hash = with_hash ? value["sha256"].get<std::string>() : std::string();
    Index number = 0;
    try {
        number = store_file(path, p.info.endings, Reading::again, std::filesystem::path(path_).parent_path().string());
    } catch (const Refused& e) {
        throw Refused(fmt::format("{} = {}{}", p.info.key, e.what(),
                                  with_hash ? fmt::format(" (the scene was saved with the file of SHA-256 {})", hash) : ""));
    }
    const StoredFile& file = stored_file(number);
    if (with_hash && number != 0 && file.sha256 != hash)
        notes_.push_back(fmt::format("{}: {} has changed since the scene was saved: its SHA-256 is {}, then it was {}",
                                     p.info.key, file.name, file.sha256, hash));
    return number == 0 ? "none" : file.path;
}

Runner::Assignments SceneReader::assignments(const SceneJson& object, const std::string& pointer) const {
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

std::string SceneReader::stage(const std::string& name, const std::string& pointer) const {
    std::vector<std::string> known;
    for (const Stage& s : lesson_->stages) known.emplace_back(s.name);
    if (!name.empty() && std::ranges::find(known, name) == known.end())
        refuse(pointer,
               fmt::format("no stage is called '{}'{}; there are: {}", name, did_you_mean(name, known), fmt::join(known, ", ")));
    return name;
}

std::string SceneReader::field(const SceneJson& object, const std::string& pointer) const {
    if (!object.contains("field")) return "";
    std::string name = text_at(object, "field", pointer + "/field");
    if (!name.empty() && !lesson_->find_field(name)) checked(pointer + "/field", [&] { lesson_->field(name); });
    return name;
}

int SceneReader::component(const SceneJson& object, const std::string& pointer, const std::string& of) const {
    if (!object.contains("component")) return -1;
    const std::string here = pointer + "/component";
    const Field* field = lesson_->find_field(of);
    const Real component = number_at(object["component"], here, "component");
    const int count = field ? field->components : 0;
    if (component != std::floor(component) || component < -1 || component >= count)
        refuse(here, fmt::format("component counts from 0 to {}, or is -1 for the whole", count - 1));
    return static_cast<int>(component);
}

std::vector<Event> SceneReader::events(const SceneJson& list, const std::string& pointer) const {
    if (!list.is_array()) refuse(pointer, "events are a list in brackets");
    std::vector<Event> result;
    for (std::size_t i = 0; i < list.size(); ++i) result.push_back(event(list[i], pointer + "/" + std::to_string(i)));
    return result;
}

Event SceneReader::event(const SceneJson& object, const std::string& pointer) const {
    known_keys(object, pointer, {"step", "set", "pull", "release"});
    Event e;
    if (!object.contains("step")) refuse(pointer, "an event needs a 'step': a whole number from 0 on");
    e.step = whole_at(object["step"], pointer + "/step", "step", 0, largest_whole);
    SceneChanges done = changes(object, pointer);
    e.assign = std::move(done.set), e.pull = done.pull, e.release = done.release;
    return e;
}

Pull SceneReader::pull(const SceneJson& object, const std::string& pointer) const {
    known_keys(object, pointer, {"index", "from", "to"});
    Pull p;
    if (object.contains("index")) p.index = whole_at(object["index"], pointer + "/index", "index", -1, largest_whole);
    if (object.contains("from")) p.from = vector_at(object["from"], pointer + "/from", "from");
    if (!object.contains("to")) refuse(pointer, "a pull needs 'to': where the thing is drawn to, three numbers in metres");
    p.to = vector_at(object["to"], pointer + "/to", "to");
    return p;
}

// ------------------------------------------------------------------------------------------------------------ version 1

Camera SceneReader::camera(const SceneJson& object, SceneFile& scene) const {
    known_keys(object, "/camera", {"target", "distance", "yaw", "pitch", "follows", "aspect"}, 4);
    Camera c;
    if (object.contains("target")) c.target = vector_at(object["target"], "/camera/target", "target");
    for (const auto& [key, member] : {std::pair{"distance", &Camera::distance}, {"yaw", &Camera::yaw}, {"pitch", &Camera::pitch}})
        if (object.contains(key)) c.*member = number_at(object[key], std::string("/camera/") + key, key);
    if (c.distance <= 0) refuse("/camera/distance", "distance is in metres and above 0");
    take_flag(object, "/camera", "follows", scene.camera_follows);
    if (object.contains("aspect")) scene.camera_aspect = number_at(object["aspect"], "/camera/aspect", "aspect");
    if (scene.camera_aspect < 0) refuse("/camera/aspect", "aspect is the width over the height of a picture, above 0");
    return c;
}

SceneView SceneReader::view(const SceneJson& object) const {
    known_keys(object, "/view",
               {"field", "component", "stage", "range", "diverging", "fixed", "change_range", "change_diverging", "arrows",
                "labels", "smooth", "patterns", "extreme", "compare", "of_stage", "swipe"},
               3);
    SceneView v;
    v.field = field(object, "/view");
    if (object.contains("stage")) v.stage = stage(text_at(object, "stage", "/view/stage"), "/view/stage");
    v.component = component(object, "/view", v.field);
    take_look(object, v);
    return v;
}

SceneFile parse_scene(std::string_view text, std::string_view path) { return SceneReader(text, path).read(); }

SceneFile read_scene(const std::string& path) { return parse_scene(read_file(path), path); }

}  // namespace pliant
