#include "app/state_report.h"

#include <pliant/text/file.h>

#include <imgui.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::viewer {

namespace {
nlohmann::ordered_json inspector_json(const LabState& lab) {
    const Inspector& in = lab.session.inspector;
    const Stage* stage = in.shown_stage(lab.session.runner());
    nlohmann::ordered_json j{{"shown", lab.side == SideTab::inspect},
                             {"compare", name_of(in.compare)},
                             {"stage", stage ? stage->name : ""},
                             {"stopped", in.stopped},
                             {"stops", in.breaks.stages},
                             {"pins", nlohmann::ordered_json::array()}};
    for (const Condition& c : in.breaks.conditions) j["conditions"].push_back(c.text());
    for (const Pin& p : in.pins) j["pins"].push_back(p.title);
    if (in.thing) j["thing"] = {{"on", name_of(in.thing->on)}, {"index", in.thing->index}};
    if (in.answer) {
        j["answer"] = nlohmann::ordered_json::parse(why_json(*in.answer, 1));
        j["questions"] = in.asked.size();
    }
    j["reach"] = lab.session.runner().reach().step;
    return j;
}

nlohmann::ordered_json claims_json(const LabState& lab) {
    const std::string_view lesson = lab.session.entry().info.id;
    const Claim* open = lab.claims.book.unfolded(lesson);
    nlohmann::ordered_json j{{"shown", lab.side == SideTab::claims},
                             {"all", lab.claims.book.all},
                             {"unfolded", open ? open->id : ""},
                             {"cards", nlohmann::ordered_json::object()}};
    for (const Claim* c : lab.claims.book.listed(lesson)) {
        auto& card = j["cards"][std::string(c->id)] = {{"stage", name_of(lab.claims.book.phase(*c))}};
        if (const auto answer = lab.claims.book.prediction(*c)) card["prediction"] = *answer;
        if (const auto right = lab.claims.book.was_right(*c)) card["right"] = *right;
        if (const ClaimResult* r = lab.claims.book.result(*c)) card["verdict"] = outcome_of(*r), card["figure"] = figure_text(*r);
    }
    return j;
}

nlohmann::ordered_json atlas_json(const LabState& lab) {
    const Atlas& a = lab.atlas.atlas;
    nlohmann::ordered_json j{{"shown", lab.side == SideTab::atlas},
                             {"across", a.across},
                             {"up", a.up},
                             {"cells", a.cells},
                             {"steps", a.steps},
                             {"busy", a.busy()},
                             {"progress", a.progress().share().value_or(0)},
                             {"trouble", a.trouble()},
                             {"mapped", a.map() && a.map()->complete},
                             {"cells_done", a.map() ? a.cells_done() : 0}};
    if (lab.atlas.cell) j["cell"] = {lab.atlas.cell->first, lab.atlas.cell->second};
    if (a.across_span) j["across_range"] = {a.across_span->range.min, a.across_span->range.max};
    if (a.up_span) j["up_range"] = {a.up_span->range.min, a.up_span->range.max};
    if (!a.map()) return j;
    j["columns"] = a.map()->columns(), j["rows"] = a.map()->rows();
    for (int k = 0; k < stability_kinds; ++k)
        j["counts"][std::string(name_of(static_cast<Stability>(k)))] = a.map()->count(static_cast<Stability>(k));
    const auto present = a.present(lab.session);
    j["present"] = present ? nlohmann::ordered_json{present->across, present->up} : nlohmann::ordered_json(nullptr);
    j["outdated"] = a.outdated(lab.session);
    return j;
}

nlohmann::ordered_json presenter_json(const PresenterState& p) {
    if (!p.open) return nullptr;
    nlohmann::ordered_json j{
        {"slide", p.view.number},          {"title", p.view.title}, {"notes", p.view.notes},          {"next", p.view.next_press},
        {"next_title", p.view.next_title}, {"black", p.view.black}, {"clock_paused", p.clock_paused}, {"frames", p.frames}};
    for (const auto& [name, c] : p.controls) j["controls"][name] = {c.x, c.y, c.width, c.height};
    return j;
}

nlohmann::ordered_json methods_json(const LabState& lab) {
    const MethodTable& t = lab.methods.table;
    nlohmann::ordered_json j{
        {"shown", lab.side == SideTab::methods}, {"over", t.over}, {"busy", t.busy()}, {"trouble", t.trouble()}};
    j["rows"] = nlohmann::ordered_json::object();
    if (t.result())
        for (const MethodRun& r : t.result()->runs) j["rows"][r.option] = name_of(r.outcome);
    return j;
}

nlohmann::ordered_json prediction_json(const LabState& lab) {
    const auto& player = lab.session.walkthrough;
    if (!player || !player->prediction()) return nullptr;
    const Guess& g = player->guess();
    constexpr std::array kinds{"choice", "number", "sketch", "words"};
    nlohmann::ordered_json j{{"kind", kinds[static_cast<std::size_t>(player->prediction()->kind)]}, {"given", g.given()}};
    if (g.option) j["option"] = *g.option + 1;
    if (g.number) j["number"] = *g.number;
    if (!g.sketch.empty()) j["sketch"] = g.sketch;
    if (!g.words.empty()) j["answer"] = g.words;
    if (g.was_right) j["was_right"] = *g.was_right;
    if (g.after_answer) j["after_answer"] = true;
    if (player->verdict()) j["right"] = player->verdict()->right, j["words"] = player->verdict()->words;
    return j;
}

nlohmann::ordered_json companion_json(const Session& s) {
    if (!s.companion()) return nullptr;
    const Runner& b = s.companion()->runner();
    nlohmann::ordered_json j{{"step", b.place().step},
                             {"time", b.time()},
                             {"stopped", s.companion()->stopped()},
                             {"addressed", s.addresses_b()},
                             {"difference", s.shows_difference()}};
    for (const Parameter* p : b.lesson().parameters) j["parameters"][std::string(p->info.key)] = p->text(b.wanted(*p));
    return j;
}

// The ring, and the control that it goes around best.
nlohmann::ordered_json focus_json(const LabState& lab) {
    const Rectangle& f = *lab.focus;
    std::string best;
    float most = 0;
    for (const auto& [name, c] : lab.controls) {
        const float width = std::min(c.x + c.width, f.x + f.width) - std::max(c.x, f.x),
                    height = std::min(c.y + c.height, f.y + f.height) - std::max(c.y, f.y);
        if (width <= 0 || height <= 0) continue;
        const float common = width * height, part = common / (c.width * c.height + f.width * f.height - common);
        if (part > most) most = part, best = name;
    }
    return {{"control", best}, {"place", {f.x, f.y, f.width, f.height}}};
}
}  // namespace

std::string state_json(const LabState& lab) {
    const Runner& r = lab.session.runner();
    const Lesson& lesson = r.lesson();
    nlohmann::ordered_json j{{"lesson", r.info().id},      {"step", r.place().step},
                             {"passes", r.place().passes}, {"step_shown", step_number(r.place())},
                             {"time", r.time()},           {"playing", lab.session.playing}};
    const auto stage = r.last_stage();
    j["stage"] = stage ? r.stages()[*stage]->name : "";
    for (const Parameter* p : lesson.parameters) j["parameters"][std::string(p->info.key)] = p->text(r.wanted(*p));
    for (const Parameter* p : lesson.parameters)
        if (r.waits(*p)) j["waiting"][std::string(p->info.key)] = {{"now", p->text(p->value())}, {"then", p->text(r.wanted(*p))}};
    for (const Probe& p : lesson.probes) {
        const auto value = p.value();
        j["probes"][std::string(p.name)] = value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nullptr;
    }
    j["pulling"] = lab.scene.pulling ? lab.scene.pulling->index : -1;
    j["hovered"] = lab.scene.hovered ? lab.scene.hovered->index : -1;
    j["message"] = lab.session.message() ? lab.session.message()->text : "";
    j["autopsy"] = lab.session.autopsy() ? lab.session.autopsy()->text() : "";
    j["summary"] = lab.summary.text;
    j["patterns"] = lab.session.patterns;
    j["typing"] = ImGui::GetCurrentContext() && ImGui::GetIO().WantTextInput;
    if (lab.focus) j["focus"] = focus_json(lab);
    j["layout"] = name_of(lab.layout);
    j["fill"] = text_of(lab.fill);
    j["black"] = lab.black;
    j["lens"] = lab.lens_shown;
    j["presenter"] = presenter_json(lab.presenter);
    j["full_screen"] = lab.full_screen;
    const auto& walkthrough = lab.session.walkthrough;
    j["slide"] = walkthrough ? lab.session.slide_number() + 1 : 0;
    j["slides"] = lab.session.slide_count();
    j["lecture"] = lab.session.lecture() ? lab.session.lecture()->path : "";
    j["extension"] = lab.session.extension() ? *lab.session.extension() + 1 : 0;
    j["revealed"] = walkthrough && walkthrough->revealed();
    j["prediction"] = prediction_json(lab);
    j["handed_in"] = lab.session.notebook.hand_in().entries.size();
    j["unlocked"] = lab.session.unlocked;
    j["notes"] = lab.notes_shown;
    j["inspector"] = inspector_json(lab);
    j["claims"] = claims_json(lab);
    j["atlas"] = atlas_json(lab);
    j["methods"] = methods_json(lab);
    j["theme"] = lab.theme == Theme::dark ? "dark" : "projector";
    j["dialog"] = lab.files.asking() ? lab.files.title() : "";
    j["complaint"] = lab.files.complaint();
    j["file"] = lab.file;
    j["recent"] = lab.recent;
    j["recording"] = lab.animation.progress.has_value();
    j["companion"] = companion_json(lab.session);
    j["pinned"] = lab.session.pinned().has_value();
    j["cost_shown"] = lab.plots.cost_shown;
    j["scale"] = lab.scale;
    j["help"] = lab.help_shown;
    j["frame"] = ImGui::GetFrameCount();
    j["resting"] = lab.resting;
    j["busy"] = nullptr;
    j["computing"] = lab.session.under_way();
    j["cut"] = lab.cut;
    for (const auto& [name, c] : lab.controls) j["controls"][name] = {c.x, c.y, c.width, c.height};
    return j.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void StateReport::write(const LabState& lab) {
    if (path_.empty()) return;
    last_ = state_json(lab);
    write_file(path_, last_);
}

void StateReport::write_busy(const BusyWords& words, const std::optional<Rectangle>& cancel, long frames) {
    if (path_.empty() || last_.empty()) return;
    auto j = nlohmann::ordered_json::parse(last_);
    j["busy"] = {{"title", words.title}, {"line", words.line}, {"frames", frames}};
    j["resting"] = false;
    if (cancel) j["controls"]["cancel work"] = {cancel->x, cancel->y, cancel->width, cancel->height};
    write_file(path_, j.dump(1) + "\n");
}

}  // namespace pliant::viewer
