// What the page of the lecturer tells, gathered while a frame is drawn.
#pragma once
#include "app/lab_state.h"

#include <optional>
#include <string_view>

namespace pliant::viewer {

PresenterView presenter_view(const LabState& lab);

// That the notes of a slide begin with: "Three minutes.", "2 minutes, a show of hands", "One minute."; empty for others.
std::optional<Real> planned_minutes(std::string_view notes);

}  // namespace pliant::viewer
