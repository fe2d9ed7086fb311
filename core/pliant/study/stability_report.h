// A stability map in files: a table for spreadsheets, JSON for programs, a few lines for people.
#pragma once
#include <pliant/study/stability_theory.h>

#include <string>

namespace pliant {

// One row per cell, row by row of the map: the two knobs with their units, class, growth per step, steps, time step over its
// limit and what theory says. Empty where there is no number. The same bits for any number of jobs.
std::string map_csv(const StabilityMap& map);

struct MapCost {
    Real seconds = 0;  // wall time
    int jobs = 1;
};

// {"lesson", "settings": {...}, "unused": {key: what it needs}, "steps" or "time", "probe", "knobs": [{"key", "symbol", "unit",
// "spacing", "values"} × 2], "cells": {"class", "growth", "steps", "theory_stable", "time_step_over_limit", "contradicts",
// "reason"} with an array each, row by row, "counts": {...}, "agreement": {"compared", "at_bound", "contradicts"} or null,
// "bound": [[x, y], [x, y]]...: values of the knobs, "cost": {"passes", "seconds", "jobs"}}
std::string map_json(const StabilityMap& map, const MapCost& cost);

// Classes with their counts, the agreement with theory, the time.
std::string map_text(const StabilityMap& map, const MapCost& cost);

// What a cell is, in words: "stable", "not converged".
std::string words_of(Stability kind);
// The agreement in a sentence: "The map agrees with theory in 1600 of 1600 cells."
std::string agreement_text(const StabilityMap& map);

}  // namespace pliant
