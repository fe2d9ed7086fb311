// A run that was pinned.
#pragma once
#include <pliant/document/scene_parts.h>
#include <pliant/lesson/scene.h>
#include <pliant/run/recorder.h>

#include <vector>

namespace pliant::viewer {

// What is kept of a run to see another one against.
struct Pinned {
    Scene ghost;
    Recorder recorder;
    std::vector<Real> settings;  // in the order of the parameters
    Index step;
    Real time;          // s
    ScenePinned scene;  // by which it is run again
};

}  // namespace pliant::viewer
