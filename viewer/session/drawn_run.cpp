#include "session/drawn_run.h"

#include <pliant/run/awaited.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

namespace pliant::viewer {

void draw_run(const Runner& runner, Scene& picture) {
    picture.awaited = awaited_fields(runner);
    runner.lesson().draw(picture);
    if (picture.override_values || !picture.awaits(picture.colour_by.field)) return;
    const Field& field = runner.lesson().field(picture.colour_by.field);
    if (const Stage* stage = awaited_stage(runner, field))
        picture.notes.insert(picture.notes.begin(), fmt::format("grey: {} is not computed yet, the stage “{}” does it",
                                                                spoken(field.name), spoken(stage->name)));
}

}  // namespace pliant::viewer
