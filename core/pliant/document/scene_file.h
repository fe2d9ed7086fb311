// Scene files: a lesson, its parameters and all that a person had before them, as JSON.
//
//   {"pliant": 1, "lesson": "mesh/mass_spring", "parameters": {"cells_x": 6, "integrator": "implicit_euler", "ground": true},
//    "camera": {"target": [0, 0.5, 0], "distance": 3, "yaw": 0.6, "pitch": 0.3},
//    "view": {"field": "velocity", "component": -1, "stage": "contact"},
//    "events": [{"step": 20, "set": {"gravity": 0}}, {"step": 40, "pull": {"index": 3, "from": [0,0,0], "to": [0,1,0]}}, {"step":
//    60, "release": true}]}
//
// Only "pliant" and "lesson" must be there. Version 2 has more, and each key of it is optional too:
//
//   "place": {"step": 40, "passes": 3, "set": {...}, "pull": {...}, "release": true, "fails": true}
//   "beside": {"set": {"stiffness": 400}, "events": [...], "now": {"set": {...}}, "addressed": true, "difference": true}
//   "pinned": {"parameters": {...}, "events": [...], "step": 40, "field": "velocity"}
//   "camera": {"yaw": 0.6, "pitch": 0.3, "follows": true}        turned, and otherwise where the lab puts it
//   "camera": {..., "aspect": 1.6}                               of the picture that it was chosen in
//   "view": {"range": [0, 2], "diverging": true, "fixed": true, "change_range": [0, 1], "change_diverging": true, "arrows":
//   false, "labels": false, "smooth": false,
//            "patterns": true, "extreme": true, "compare": "swipe", "of_stage": "contact", "swipe": 0.3}
//   "stops": {"stages": ["contact"], "passes": [...], "conditions": ["energy > 2"], "assumptions": true, "laws": true}
//   "inspector": {"on": "node", "index": 5, "asked": [{"field": "velocity", "index": 5}], "pinned": [{..., "from": 20}]}
//   "slide": {"number": 3, "revealed": true, "unlocked": true, "extension": 1, "lecture": "talk.md",
//             "predicted": {"option": 2}}   or {"number": 0.2}, {"sketch": [1, 2]}, {"words": "It grows.", "right": true}
//   "layout": {"layout": "slide", "tab": "atlas", "claim": "E4", "fill": "plot energy"}
//   "plots": {"shown": ["energy"], "plots": {"energy": {"x": [0, 1], "y_log": true, "hidden": ["exact"]}}, "cost": true,
//             "axis": 1, "across": [0.5, 0.2]}
//   "atlas": {"across": {"key": "time_step", "range": [0.001, 0.1], "log": true}, "up": {...}, "cells": 40, "steps": 200}
//
// A parameter that is a file is {"path": "part.msh", "sha256": "..."} or its path alone, relative to the scene file, or the name
// of a body that comes with Pliant. Where the bytes have another hash now, the scene has a note.
//
// A scene is written as version 2 only if it needs to be, so that an older program opens what it can and says "newer" of the
// rest. An unknown key, a wrong type or a newer version is refused with file, line and column.
#pragma once
#include <pliant/document/scene_parts.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

struct SceneFile {
    std::string lesson;
    Runner::Assignments parameters;
    std::optional<Camera> camera{};
    std::optional<SceneView> view{};
    std::vector<Event> events{};
    // --- of version 2 ---
    bool camera_follows = false;  // of the camera only yaw and pitch are the person's
    Real camera_aspect = 0;       // width over height of the picture that it was chosen in; 0 where nobody knows
    std::optional<ScenePlace> place{};
    std::optional<SceneBeside> beside{};
    std::optional<ScenePinned> pinned{};
    SceneStops stops{};
    SceneInspector inspector{};
    std::optional<SceneSlide> slide{};
    std::optional<SceneLayout> layout{};
    ScenePlots plots{};
    std::optional<SceneAtlas> atlas{};

    // What was noticed as it was read, and is no reason to refuse it: a file that is another one now than when it was saved.
    std::vector<std::string> notes{};

    // The version that it is written in, 1 or 2.
    int version() const;
};

// `path` is for messages. Checks the lesson, its keys, types and values against what the lesson declares. Throws Refused as
// "path:line:column: ...".
SceneFile parse_scene(std::string_view text, std::string_view path);
SceneFile read_scene(const std::string& path);

// The text reads back as the same scene, numbers to the bit.
std::string scene_text(const SceneFile& scene);
// The same for a file of this path: a mesh in its folder, or below it, is named from there.
std::string scene_text_for(const SceneFile& scene, const std::string& path);
// The same in one line, without blanks.
std::string compact_scene_text(const SceneFile& scene);

// The scene of a run: its lesson, the parameters that it began with where they differ from their initial values, its script and
// what was done since. Run as many steps, the scene ends in the same state.
SceneFile scene_of(const Runner& runner);
// The same, with the place where it stands, and apart from it what was done there.
SceneRun run_of(const Runner& runner);
// Both in one scene, so that it can be gone on with.
SceneFile placed_scene_of(const Runner& runner);
// What was done at a place.
void apply_to(Runner& runner, const SceneChanges& changes);
// The run from its start to the place of the scene. Throws Refused and Diverged.
void play_to_place(Runner& runner, const SceneFile& scene);

// A scene that came with a lesson, by its name; throws Refused with the nearest known name.
SceneFile preset(const LessonEntry& entry, std::string_view name);

}  // namespace pliant
