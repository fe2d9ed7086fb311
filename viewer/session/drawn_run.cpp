#include "session/drawn_run.h"

#include <pliant/run/awaited.h>

namespace pliant::viewer {

void draw_run(const Runner& runner, Scene& picture) {
    picture.awaited = awaited_fields(runner);
    runner.lesson().draw(picture);
}

}  // namespace pliant::viewer
