// Scene files: a lesson, its parameters and what the person was looking at, as JSON.
//
//   {"pliant": 1, "lesson": "mesh/mass_spring", "parameters": {"cells_x": 6, "integrator": "implicit_euler", "ground": true},
//    "camera": {"target": [0, 0.5, 0], "distance": 3, "yaw": 0.6, "pitch": 0.3},
//    "view": {"field": "velocity", "component": -1, "stage": "contact", "line": "u_center"},
//    "events": [{"step": 20, "set": {"gravity": 0}}, {"step": 40, "pull": {"index": 3, "from": [0,0,0], "to": [0,1,0]}}, {"step":
//    60, "release": true}]}
//
// Only "pliant" and "lesson" must be there. An unknown key, a wrong type or a newer version is refused with file, line and
// column.
#pragma once
#include <pliant/run/runner.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

struct Camera {
    Vec<3> target = Vec<3>::Zero();  // m
    Real distance = 1;               // m; in 2D the height of what is seen
    Real yaw = 0, pitch = 0;         // rad
    bool operator==(const Camera&) const = default;
};

struct SceneView {
    std::string field;  // that colours the picture
    int component = -1;
    std::string stage;  // to stop after, in the step being shown
    bool operator==(const SceneView&) const = default;
};

struct SceneFile {
    std::string lesson;
    Runner::Assignments parameters;
    std::optional<Camera> camera{};
    std::optional<SceneView> view{};
    std::vector<Event> events{};
};

// `path` is for messages. Checks the lesson, its keys, types and values against what the lesson declares. Throws Refused as
// "path:line:column: ...".
SceneFile parse_scene(std::string_view text, std::string_view path);
SceneFile read_scene(const std::string& path);

// The text reads back as the same scene, numbers to the bit.
std::string scene_text(const SceneFile& scene);
// The same in one line, without blanks.
std::string compact_scene_text(const SceneFile& scene);

// The scene of a run: its lesson, the parameters that it began with where they differ from their initial values, its script and
// what was done since. Run as many steps, the scene ends in the same state.
SceneFile scene_of(const Runner& runner);

// A scene that came with a lesson, by its name; throws Refused with the nearest known name.
SceneFile preset(const LessonEntry& entry, std::string_view name);

}  // namespace pliant
