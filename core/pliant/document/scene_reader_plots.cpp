// The plots and the atlas of a scene.
#include <pliant/document/scene_json.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {

// followed: how many numbers are.
void SceneReader::check_plot(const std::string& name, const std::string& pointer, std::size_t followed) const {
    std::vector<std::string> known{"along", "map"};
    for (const Probe& p : lesson_->probes) known.emplace_back(p.name);
    for (const Line& l : lesson_->lines) known.emplace_back(l.name);
    for (std::size_t i = 0; i < followed; ++i) known.push_back(fmt::format("pin {}", i + 1));
    if (std::ranges::find(known, name) == known.end())
        refuse(pointer,
               fmt::format("no plot is called '{}'{}; there are: {}", name, did_you_mean(name, known), fmt::join(known, ", ")));
}

ScenePlots SceneReader::plots(const SceneJson& object, std::size_t followed) const {
    known_keys(object, "/plots", {"shown", "plots", "cost", "axis", "across"});
    ScenePlots all;
    if (object.contains("shown")) {
        all.shown = texts_at(object, "/plots", "shown");
        for (std::size_t i = 0; i < all.shown->size(); ++i)
            check_plot((*all.shown)[i], fmt::format("/plots/shown/{}", i), followed);
    }
    if (object.contains("plots")) {
        const SceneJson& each = object["plots"];
        if (!each.is_object()) refuse("/plots/plots", "an object in braces is expected here: {\"energy\": {...}}");
        for (const auto& [name, value] : each.items()) {
            const std::string here = "/plots/plots/" + pointer_part(name);
            check_plot(name, here, followed);
            all.plots.push_back(plot(value, here, name));
        }
    }
    take_flag(object, "/plots", "cost", all.cost);
    Index axis = 0;
    take_whole(object, "/plots", "axis", 0, 2, axis);
    all.axis = static_cast<int>(axis);
    if (const auto both = object.find("across"); both != object.end()) {
        if (!both->is_array() || both->size() != 2)
            refuse("/plots/across", "'across' is two numbers in brackets, each from 0 to 1");
        for (std::size_t i = 0; i < 2; ++i) {
            all.across[i] = number_at((*both)[i], "/plots/across", "across");
            if (all.across[i] < 0 || all.across[i] > 1) refuse("/plots/across", "each number of 'across' is from 0 to 1");
        }
    }
    return all;
}

ScenePlot SceneReader::plot(const SceneJson& object, const std::string& pointer, const std::string& name) const {
    known_keys(object, pointer, {"x", "y", "x_log", "y_log", "hidden"});
    ScenePlot p{.name = name, .x = range_at(object, pointer, "x"), .y = range_at(object, pointer, "y")};
    for (const auto& [key, log] : {std::pair{"x_log", &p.x_log}, {"y_log", &p.y_log}})
        if (object.contains(key)) take_flag(object, pointer, key, log->emplace());
    p.hidden = texts_at(object, pointer, "hidden");
    return p;
}

SceneKnob SceneReader::knob(const SceneJson& object, const std::string& pointer) const {
    known_keys(object, pointer, {"key", "range", "log"});
    SceneKnob k;
    if (!object.contains("key")) refuse(pointer, "a knob of the atlas needs a 'key': that of a parameter");
    k.key = text_at(object, "key", pointer + "/key");
    checked(pointer + "/key", [&] { lesson_->parameter(k.key); });
    k.range = range_at(object, pointer, "range");
    if (k.range)
        checked(pointer + "/range", [&] {
            const Parameter& p = lesson_->parameter(k.key);
            p.check(k.range->min), p.check(k.range->max);
        });
    take_flag(object, pointer, "log", k.log);
    return k;
}

SceneAtlas SceneReader::atlas(const SceneJson& object) const {
    known_keys(object, "/atlas", {"across", "up", "cells", "steps"});
    for (const char* key : {"across", "up"})
        if (!object.contains(key)) refuse("/atlas", "the atlas has two knobs, 'across' and 'up'");
    SceneAtlas a{.across = knob(object["across"], "/atlas/across"), .up = knob(object["up"], "/atlas/up")};
    if (a.across.key == a.up.key) refuse("/atlas/up", "the atlas has two knobs: 'across' and 'up' are the same parameter");
    if (object.contains("cells")) take_whole(object, "/atlas", "cells", 2, SceneAtlas::most_cells, a.cells.emplace());
    if (object.contains("steps")) take_whole(object, "/atlas", "steps", 16, SceneAtlas::most_steps, a.steps.emplace());
    return a;
}

}  // namespace pliant
