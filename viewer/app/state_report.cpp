#include "app/state_report.h"

#include <pliant/lesson/file.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace pliant::viewer {

std::string state_json(const LabState& lab) {
    const Runner& r = lab.session.runner();
    const Lesson& lesson = r.lesson();
    nlohmann::ordered_json j{{"lesson", r.info().id},
                             {"step", r.place().step},
                             {"passes", r.place().passes},
                             {"time", r.time()},
                             {"playing", lab.session.playing}};
    const auto stage = r.last_stage();
    j["stage"] = stage ? r.stages()[*stage]->name : "";
    for (const Parameter* p : lesson.parameters) j["parameters"][std::string(p->info.key)] = p->text(r.wanted(*p));
    for (const Probe& p : lesson.probes) {
        const auto value = p.value();
        j["probes"][std::string(p.name)] = value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nullptr;
    }
    j["pulling"] = lab.pulling ? lab.pulling->index : -1;
    j["hovered"] = lab.hovered ? lab.hovered->index : -1;
    j["message"] = lab.session.message() ? lab.session.message()->text : "";
    j["layout"] = lab.layout == Layout::lab ? "lab" : "slide";
    j["theme"] = lab.theme == Theme::dark ? "dark" : "projector";
    j["dialog"] = lab.files.asking() ? lab.files.title() : "";
    j["complaint"] = lab.files.complaint();
    j["file"] = lab.file;
    j["recent"] = lab.recent;
    j["recording"] = lab.animation.progress.has_value();
    j["scale"] = lab.scale;
    j["help"] = lab.help_shown;
    j["frame"] = ImGui::GetFrameCount();
    for (const auto& [name, c] : lab.controls) j["controls"][name] = {c.x, c.y, c.width, c.height};
    return j.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void StateReport::write(const LabState& lab) {
    if (!path_.empty()) write_file(path_, state_json(lab));
}

}  // namespace pliant::viewer
