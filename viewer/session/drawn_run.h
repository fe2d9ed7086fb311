// A run in a picture.
#pragma once
#include <pliant/lesson/scene.h>
#include <pliant/run/runner.h>

namespace pliant::viewer {

// As its lesson draws it, with what no stage has computed yet marked.
void draw_run(const Runner& runner, Scene& picture);

}  // namespace pliant::viewer
