#include "panels/companion_panel.h"

#include "panels/typeset_text.h"

#include <pliant/document/summary.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/run/awaited.h>
#include <pliant/text/format.h>

#include "session/live_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

std::string joined(const std::vector<std::string>& texts, std::size_t most) {
    const auto end = texts.begin() + static_cast<std::ptrdiff_t>(std::min(most, texts.size()));
    return fmt::format("{}{}", fmt::join(texts.begin(), end, ", "), texts.size() > most ? ", …" : "");
}

struct Row {
    std::string name, symbol, a, b, difference, help;
};

// Of the size of what this number has been: less is rounding.
constexpr Real rounding = 1e-12;

std::string number_text(std::optional<Real> value, std::string_view unit, int digits, Real size) {
    if (!value) return "—";
    if (*value != 0 && std::abs(*value) < rounding * size) return "≈ 0";
    return format_quantity(*value, unit, digits);
}

// size: the largest that either number has been.
Row row_of(std::string name, std::string_view unit, std::optional<Real> a, std::optional<Real> b, std::string help, int digits,
           Real size) {
    const auto difference = a && b ? std::optional(*a - *b) : std::nullopt;
    return {std::move(name),
            "",
            number_text(a, unit, digits, size),
            number_text(b, unit, digits, size),
            number_text(difference, unit, std::min(digits, 3), size),
            std::move(help)};
}

Real largest(const TimeSeries& series) {
    Real size = 0;
    for (const Real value : series.values())
        if (std::isfinite(value)) size = std::max(size, std::abs(value));
    return size;
}

std::optional<Real> seconds(std::optional<Real> ms) { return ms ? std::optional(*ms / 1000) : std::nullopt; }

// None while a stage has yet to compute it. Of B too when the numbers of one run are not finite, which the run itself tells in
// words.
std::optional<Real> value_of(const Runner& runner, const Probe& probe) {
    if (awaited_stage(runner, probe)) return std::nullopt;
    try {
        return runner.value(probe);
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::vector<Row> rows_of(const Session& s, int digits) {
    const Companion& b = *s.companion();
    const auto& probes = s.lesson().probes;
    std::vector<Row> rows;
    for (const Probe* p : key_probes(s.lesson())) {
        const auto i = static_cast<std::size_t>(p - probes.data());
        const auto of_a = value_of(s.runner(), *p);
        const auto of_b = s.catching_up() ? std::nullopt : value_of(b.runner(), b.lesson().probe(p->name));
        Real size = std::max(std::abs(of_a.value_or(0)), std::abs(of_b.value_or(0)));
        for (const Recorder* r : {&s.recorder(), &b.recorder()})
            if (!r->empty()) size = std::max(size, largest(r->series(i)));
        rows.push_back(row_of(words(p->name), p->unit, of_a, of_b,
                              fmt::format("{}\n{}", named_with_symbol(p->name, p->symbol), p->help), digits, size));
        rows.back().symbol = p->symbol;
        if (s.hides(p->name)) rows.back().a = rows.back().b = "?", rows.back().difference = "";
    }
    rows.push_back(row_of("Per step", "s", seconds(s.costs().step_ms()), seconds(b.costs().step_ms()),
                          "what a step costs: the median of the latest", digits, 0));
    const auto measured = std::ranges::find(probes, s.lesson().error_probe(), &Probe::name);
    if (measured == probes.end() || !measured->exact || s.hides(measured->name) || s.hides("theory")) return rows;
    const auto i = static_cast<std::size_t>(measured - probes.begin());
    const auto error = [&](const Recorder& r) { return r.empty() ? std::nullopt : error_against_exact(r.series(i)).latest(); };
    const auto of_a = error(s.recorder()), of_b = s.catching_up() ? std::nullopt : error(b.recorder());
    if (!of_a && !of_b) return rows;
    const Real size = std::max(std::abs(of_a.value_or(0)), std::abs(of_b.value_or(0)));
    rows.push_back(
        row_of("Error", "", of_a, of_b, fmt::format("|value − exact| / max|exact| of {}", words(measured->name)), digits, size));
    return rows;
}

struct Column {
    std::string Row::*text;
    const char* title;
};

// A slide leaves out the difference, for names and digits that are read from afar.
std::vector<Column> columns_of(Layout layout) {
    std::vector<Column> columns{{&Row::a, "A"}, {&Row::b, "B"}};
    if (layout == Layout::lab) columns.push_back({&Row::difference, "A − B"});
    return columns;
}

// Of the numbers, px.
float numbers_width(const std::vector<Row>& rows, const std::vector<Column>& columns) {
    float sum = 0;
    for (const auto& [column, title] : columns) {
        float width = ImGui::CalcTextSize(title).x;
        for (const Row& row : rows) width = std::max(width, ImGui::CalcTextSize((row.*column).c_str()).x);
        sum += width + 2 * ImGui::GetStyle().CellPadding.x + 1;
    }
    return sum;
}

// With as many digits as leave the names some room.
std::vector<Row> fitting_rows(const Session& s, const std::vector<Column>& columns, float width, float least_names) {
    for (const int digits : {3, 2}) {
        std::vector<Row> rows = rows_of(s, digits);
        if (numbers_width(rows, columns) + least_names <= width) return rows;
    }
    return rows_of(s, 1);
}

// A button that stays lit while what it stands for is on.
bool toggle_button(PanelContext& lab, const char* name, const char* control, bool on, const char* help) {
    if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(name).x + 2 * ImGui::GetStyle().FramePadding.x) ImGui::NewLine();
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool used = ImGui::Button(name);
    if (on) ImGui::PopStyleColor();
    lab.note_control(control);
    tooltip(help, lab.scale);
    ImGui::SameLine(0, lab.px(4));
    return used;
}

}  // namespace

std::string setting_text(const Parameter& p, Real value) {
    switch (p.info.kind) {
        case Kind::choice: {
            const std::string_view label = p.info.options[static_cast<std::size_t>(value)].label;
            const std::string_view name = label.substr(0, label.find(':'));
            // A single word, such as "none", does not say what it is about.
            return name.find(' ') == name.npos ? fmt::format("{} {}", words(p.info.key), name) : std::string(name);
        }
        case Kind::toggle:
            return fmt::format("{} {}", words(p.info.key), value != 0 ? "on" : "off");
        case Kind::file:
            return fmt::format("{} {}", words(p.info.key), value_words(p, value));
        case Kind::number:
        case Kind::whole:
            break;
    }
    const std::string name = p.info.symbol.empty() ? words(p.info.key) : std::string(p.info.symbol);
    return fmt::format("{} = {}", name, format_quantity(value, p.info.unit));
}

namespace {

// " from step 13 on", for a parameter that was changed within the run: its numbers before are of another setting. By hand, or by
// the events of a scene that have come.
std::string since_text(const Runner& runner, std::string_view key) {
    const auto sets = [&](const Event& e) {
        return std::ranges::any_of(e.assign, [&](const auto& a) { return a.first == key; });
    };
    const auto has_come = [&](const Event& e) {
        return e.step < runner.place().step || (e.step == runner.place().step && runner.inside_step());
    };
    Index since = 0;
    for (const Event& e : runner.events())
        if (sets(e) && has_come(e)) since = std::max(since, e.step);
    for (const Event& e : runner.recording().events())
        if (sets(e)) since = std::max(since, e.step);
    return since > 0 ? fmt::format(" from step {} on", since + 1) : "";
}

}  // namespace

std::string differing_text(const Session& s, bool of_b, std::size_t most) {
    if (!s.companion() || s.hides("titles")) return "";
    const Runner& run = of_b ? s.companion()->runner() : s.runner();
    std::vector<std::string> texts;
    for (const Differing& d : differing(s.runner(), s.companion()->runner())) {
        const std::string_view key = d.parameter->info.key;
        texts.push_back(s.hides(key) ? fmt::format("{} ?", words(key))
                                     : setting_text(*d.parameter, of_b ? d.b : d.a) + since_text(run, key));
    }
    return joined(texts, most);
}

std::string run_name(const Session& s, bool of_b, std::size_t most) {
    const std::string settings = differing_text(s, of_b, most);
    return fmt::format("{}{}{}", of_b ? "B" : "A", settings.empty() ? "" : "  ", settings);
}

std::string catching_up_text(const Session& s) {
    const auto share = s.catching_up();
    return share ? fmt::format("B is catching up: {:.0f} %", std::floor(100 * *share)) : "";
}

std::string pinned_text(const Session& s) {
    if (!s.pinned()) return "";
    std::vector<std::string> texts;
    const std::vector<Real> now = settings_of(s.runner());
    for (std::size_t i = 0; i < now.size(); ++i)
        if (now[i] != s.pinned()->settings[i]) texts.push_back(setting_text(*s.lesson().parameters[i], s.pinned()->settings[i]));
    const std::string when = s.runner().is_static() ? fmt::format("at step {}", s.pinned()->step)
                                                    : fmt::format("at t = {}", format_quantity(s.pinned()->time, "s"));
    return fmt::format("pinned {}{}{}", when, texts.empty() ? "" : ": ", joined(texts, 3));
}

void draw_pin_button(PanelContext& lab) {
    Session& s = lab.session;
    if (toggle_button(lab, s.pinned() ? "Unpin" : "Pin", "pin", s.pinned().has_value(),
                      "Keep this run behind the present one: its picture as outlines, its numbers dashed in the plots (G)"))
        s.toggle_pin();
}

void draw_run_switch(PanelContext& lab) {
    Session& s = lab.session;
    if (toggle_button(lab, "A|B", "beside", s.companion() != nullptr,
                      "Two runs of this lesson side by side, with parameters of their own and linked clocks. B runs up to where "
                      "this one stands (2)"))
        s.toggle_companion();
    if (!s.companion()) return ImGui::NewLine();
    for (const bool b : {false, true}) {
        if (ImGui::RadioButton(b ? "B" : "A", s.addresses_b() == b)) s.address(b);
        lab.note_control(b ? "run B" : "run A");
        tooltip(
            fmt::format("The sliders set run {0}, the {1} picture (Ctrl {2})", b ? "B" : "A", b ? "right" : "left", b ? 2 : 1),
            lab.scale);
        ImGui::SameLine();
    }
    ImGui::BeginDisabled(!s.has_difference());
    if (toggle_button(lab, "A − B", "difference", s.shows_difference(),
                      "The difference of the two runs in the field that is shown; both must have as many numbers (3)"))
        s.show_difference(!s.shows_difference());
    ImGui::EndDisabled();
    ImGui::NewLine();
}

float companion_table_height(const PanelContext& lab) {
    if (!lab.session.companion() || lab.layout != Layout::lab) return 0;
    const float row = lab.fonts.small->FontSize + 2 * ImGui::GetStyle().CellPadding.y;
    return static_cast<float>(rows_of(lab.session, 1).size() + 1) * row + lab.px(6);
}

void draw_companion_table(PanelContext& lab) {
    if (!lab.session.companion()) return;
    ImFont* font = lab.layout == Layout::lab ? lab.fonts.small : lab.fonts.normal;
    const float room = ImGui::GetContentRegionAvail().x, names = lab.px(36);
    const std::vector<Column> columns = columns_of(lab.layout);
    ImGui::PushFont(font);
    std::vector<Row> rows = fitting_rows(lab.session, columns, room, names);
    const bool fits = numbers_width(rows, columns) + names <= room;
    ImGui::PopFont();
    if (!fits) font = lab.fonts.small;
    ImGui::PushFont(font);
    if (!fits) rows = fitting_rows(lab.session, columns, room, names);
    if (ImGui::BeginTable("two runs", 1 + static_cast<int>(columns.size()),
                          ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
        for (const Column& column : columns) ImGui::TableSetupColumn(column.title, ImGuiTableColumnFlags_WidthFixed);
        ImGui::TableHeadersRow();
        for (const Row& row : rows) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            // Where the name has no room the symbol stands for it, and the tooltip has both.
            const bool whole = ImGui::CalcTextSize(row.name.c_str()).x <= ImGui::GetContentRegionAvail().x;
            fitted_sentence(lab, whole || row.symbol.empty() ? row.name : as_formula(row.symbol),
                            ImGui::GetContentRegionAvail().x);
            sentence_tooltip(lab, row.help);
            for (const Column& column : columns) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted((row.*column.text).c_str());
            }
        }
        ImGui::EndTable();
    }
    ImGui::PopFont();
    lab.note_control("two runs");
}

}  // namespace pliant::viewer
