#include "panels/methods_panel.h"

#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include "panels/flowing_text.h"
#include "panels/typeset_text.h"
#include "session/worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace pliant::viewer {
namespace {

using Outcome = MethodRun::Outcome;

void choose_over(PanelContext& lab, MethodTable& table) {
    const auto choices = comparable_choices(lab.session.lesson());
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##over", fmt::format("every {}", words(table.over)).c_str())) {
        for (const Parameter* p : choices)
            if (ImGui::Selectable(fmt::format("every {}", words(p->info.key)).c_str(), p->info.key == table.over))
                table.over = p->info.key;
        ImGui::EndCombo();
    }
    lab.note_control("methods over");
    tooltip("The choice whose options are compared", lab.scale);
}

// "8 runs of 2000 steps each: about 12 s, by the first steps of each."
std::string work_words(const MethodTable::Work& work) {
    std::string text = counted(work.runs, "run");
    if (work.steps > 0) text += fmt::format(" of {} each", counted(work.steps, "step"));
    if (work.seconds)
        text += fmt::format(": about {}{}", duration_words(*work.seconds),
                            work.steps > 0 ? ", by the first steps of each" : " at the pace of this run");
    return text + ".";
}

void compare_or_cancel(PanelContext& lab, MethodsPanelState& panel) {
    MethodTable& table = panel.table;
    if (!table.busy()) {
        const bool pressed =
            flowing_button(lab, table.result() ? "Compare again" : "Compare all", "methods make",
                           "Runs the present scene with each of them, beside the lab, as far as it has run", true);
        if (std::exchange(panel.focus, false)) focus_last_item();
        if (pressed) table.start(lab.session);
        return;
    }
    if (flowing_button(lab, "Cancel", "methods cancel", "Calls the comparison off", true)) table.cancel();
    ImGui::SameLine();
    const Watch::Progress progress = table.progress();
    ImGui::ProgressBar(static_cast<float>(progress.share().value_or(0)), {-1, 0});
    lab.note_control("methods progress");
}

std::string passes_text(const MethodRun& r) { return fmt::format("{}", r.passes); }
std::string time_text(const MethodRun& r) { return r.ran() ? format_quantity(r.ms / 1000, "s", 3) : "–"; }

std::string error_text(const MethodRun& r) {
    if (!r.error) return "–";
    return *r.error < 1e-4 ? format_quantity(*r.error, "", 2) : fmt::format("{} %", format_quantity(100 * *r.error, "", 3));
}

// Where no run has an error, the number itself is compared.
std::string value_text(const MethodRun& r, const MethodComparison& c) {
    return r.value ? format_quantity(*r.value, c.unit, 3) : "–";
}
std::string third_text(const MethodRun& r, const MethodComparison& c) {
    return c.no_error.empty() ? error_text(r) : value_text(r, c);
}

Rgba8 colour_of(Outcome outcome) {
    return outcome == Outcome::stopped || outcome == Outcome::grows || outcome == Outcome::refused ? bad_colour : good_colour;
}

const char* mark_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::steady:
        case Outcome::finished:
            return "✓";
        case Outcome::loses:
            return "▾";
        case Outcome::grows:
            return "▴";
        default:
            return "✗";
    }
}

void table_row(PanelContext& lab, const MethodComparison& c, std::size_t k) {
    const MethodRun& r = c.runs[k];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(k));
    if (ImGui::Selectable(("##" + r.option).c_str(), false, ImGuiSelectableFlags_SpanAllColumns,
                          {0, ImGui::GetTextLineHeight()}) &&
        r.ran())
        open_method_beside(lab.session, c, k);
    lab.note_control("method " + r.option);
    tooltip(fmt::format("{}: {}\n{}", r.label, r.words, r.ran() ? "Click: as run B beside this one" : ""), lab.scale);
    ImGui::PopID();
    ImGui::SameLine(0, 0);
    fitted_text(r.label, ImGui::GetContentRegionAvail().x);
    lab.note_control("method name " + r.option);
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, packed(colour_of(r.outcome)));
    ImGui::TextUnformatted(mark_of(r.outcome));
    ImGui::PopStyleColor();
    tooltip(std::string(name_of(r.outcome)) + ": " + r.words, lab.scale);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(third_text(r, c).c_str());
    lab.note_control("method error " + r.option);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(passes_text(r).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(time_text(r).c_str());
    lab.note_control("method time " + r.option);
}

// As wide as its head and its widest text.
float column_width(const MethodComparison& c, const char* head, const std::function<std::string(const MethodRun&)>& text) {
    float width = ImGui::CalcTextSize(head).x;
    for (const MethodRun& r : c.runs) width = std::max(width, ImGui::CalcTextSize(text(r).c_str()).x);
    return width;
}

void draw_table(PanelContext& lab, const MethodComparison& c) {
    ImGui::PushFont(lab.fonts.small);
    // The names take what the numbers leave; where that is too little to tell them apart, the table scrolls sideways.
    constexpr int columns = 5;
    const char* const third = c.no_error.empty() ? "error" : "value";
    const std::array<float, columns - 1> widths{ImGui::CalcTextSize("✓").x,
                                                column_width(c, third, [&](const MethodRun& r) { return third_text(r, c); }),
                                                column_width(c, "passes", passes_text), column_width(c, "took", time_text)};
    const float padding = 2 * ImGui::GetStyle().CellPadding.x, numbers = std::accumulate(widths.begin(), widths.end(), 0.f),
                left = ImGui::GetContentRegionAvail().x - numbers - columns * padding, least = lab.px(84);
    const bool scrolls = left < least;
    const float rows = static_cast<float>(c.runs.size() + 1) * (ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y),
                height = scrolls ? rows + ImGui::GetStyle().ScrollbarSize + lab.px(2) : 0;
    if (ImGui::BeginTable("methods", columns,
                          ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit | (scrolls ? ImGuiTableFlags_ScrollX : 0),
                          {0, height})) {
        if (scrolls) ImGui::TableSetupScrollFreeze(1, 1);
        constexpr int fixed = ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_NoResize;
        ImGui::TableSetupColumn(words(c.parameter).c_str(), fixed, std::max(left, least));
        const std::array heads{"", third, "passes", "took"};
        for (std::size_t k = 0; k < heads.size(); ++k) ImGui::TableSetupColumn(heads[k], fixed, widths[k]);
        ImGui::TableHeadersRow();
        for (std::size_t k = 0; k < c.runs.size(); ++k) table_row(lab, c, k);
        ImGui::EndTable();
    }
    ImGui::PopFont();
}

void plot_runs(PanelContext& lab, MethodsPanelState& panel, const MethodComparison& c) {
    Plot plot(panel.memory, style_of_plots(lab), {});
    const float width = ImGui::GetContentRegionAvail().x,
                height = std::clamp(ImGui::GetContentRegionAvail().y, lab.px(170), width);
    const Axes axes{.x = c.is_static ? Axis{"step", ""} : Axis{"time t", "s"}, .y = {words(c.probe), c.unit}};
    if (!plot.begin(fmt::format("{}##methods", words(c.probe)), {0, height}, axes)) return;
    for (const MethodRun& r : c.runs)
        if (r.ran() && !r.curve.empty())
            plot.line(r.label.substr(0, r.label.find(':')), r.curve.at(), r.curve.values(),
                      {.dash = r.outcome == Outcome::stopped ? Dash::dashed : Dash::solid});
    if (!c.reference_at.empty())
        plot.reference(c.reference.starts_with("the exact") ? "exact" : "finer", c.reference_at, c.reference_value);
    plot.end();
}

}  // namespace

void draw_methods(PanelContext& lab, MethodsPanelState& panel) {
    MethodTable& table = panel.table;
    if (table.over.empty()) {
        sentence_item(lab, "This scene has no choice of methods to compare.");
        return;
    }
    choose_over(lab, table);
    compare_or_cancel(lab, panel);
    if (!table.trouble().empty()) sentence_item(lab, table.trouble());
    const auto so_far = table.so_far();
    const MethodComparison* c = table.busy() ? so_far.get() : table.result();
    if (table.busy() || !c || table.outdated(lab.session)) {
        sentence_item(lab, work_words(table.work(lab.session)));
        lab.note_control("methods work");
    }
    if (!c) {
        if (table.trouble().empty() && !table.busy())
            sentence_item(
                lab,
                "Each of them runs from the start of this scene to where it stands now: which last, how wrong they are, and "
                "what they cost.");
        return;
    }
    ImGui::PushFont(lab.fonts.small);
    if (table.busy())
        sentence_item(lab, fmt::format("{} done so far.", counted(static_cast<long long>(c->runs.size()), "run")));
    else if (table.outdated(lab.session))
        sentence_item(lab, "The scene has changed since: compare again.");
    if (!table.busy())
        sentence_item(lab, !c->no_error.empty() ? fmt::format("{} Compared is the {} at the end.", c->no_error, spoken(c->probe))
                                                : fmt::format("{} each; error of the {} against {}.", counted(c->steps, "step"),
                                                              spoken(c->probe), c->reference));
    ImGui::PopFont();
    draw_table(lab, *c);
    plot_runs(lab, panel, *c);
}

void what_if_menu(PanelContext& lab, const Parameter& p) {
    if (!ImGui::BeginPopupContextItem("what if")) return;
    ImGui::TextDisabled("What if %s were …", words(p.info.key).c_str());
    const auto all = what_if(lab.session, p);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (ImGui::MenuItem(all[k].words.c_str())) compare_what_if(lab.session, p, all[k]);
        lab.note_control(fmt::format("what if {}", k + 1));
    }
    if (p.info.kind == Kind::choice && ImGui::MenuItem("all of them, in a table")) {
        lab.methods_over = std::string(p.info.key);
        lab.wanted.push_back(Action::methods);
    }
    ImGui::EndPopup();
}

void draw_what_if_words(PanelContext& lab) {
    const std::string text = what_if_words(lab.session);
    if (text.empty()) return;
    sentence_item(lab, text);
    lab.note_control("what if words");
}

}  // namespace pliant::viewer
