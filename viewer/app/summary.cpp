#include "app/summary.h"

#include <pliant/document/summary.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/study/stability_report.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace pliant::viewer {
namespace {

std::string colours_sentence(const Session& s) {
    const Field* field = s.lesson().find_field(s.colours.field);
    if (!field || !field->in_use() || s.hides(field->name)) return "";
    const ColourScale& scale = s.colour_scale();
    return fmt::format("The picture shows {}, from {} to {}.\n", words(field->name), format_quantity(scale.min, field->unit, 3),
                       format_quantity(scale.max, field->unit, 3));
}

std::string thing_sentences(const Session& s) {
    const auto& thing = s.inspector.thing;
    if (!thing) return "";
    std::string text = fmt::format("Picked: {} {}.\n", name_of(thing->on), thing->index);
    for (const Field& f : s.lesson().fields) {
        if (!f.in_use() || s.hides(f.name) || f.on != thing->on || thing->index >= f.size()) continue;
        const std::string name = words(f.name);
        text +=
            fmt::format("{}{} {} {}", f.rank == Rank::scalar ? "" : "The size of ", name,
                        f.rank == Rank::scalar ? is_or_are(name) : "is", format_quantity(row_value(f, thing->index, -1), f.unit));
        if (f.rank != Rank::scalar) {
            const auto names = component_names(f);
            for (int c = 0; c < f.components; ++c)
                text += fmt::format("{}{} {}", c ? ", " : ": ", names[static_cast<std::size_t>(c)],
                                    format_quantity(row_value(f, thing->index, c), f.unit));
        }
        text += ".\n";
    }
    return text;
}

std::optional<Real> number_of(const Runner& r, const Probe& p) {
    try {
        const auto value = r.value(p);
        return value && std::isfinite(*value) ? value : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

// The second run: what it has otherwise, where it stands, and its key numbers against those of A.
std::string beside_sentences(const Session& s) {
    if (!s.companion()) return "";
    const Runner &a = s.runner(), &b = s.companion()->runner();
    std::vector<std::string> settings;
    for (const Differing& d : differing(a, b)) {
        if (s.hides(d.parameter->info.key)) continue;
        settings.push_back(fmt::format("{} in place of {}", setting_words(*d.parameter, d.b), value_words(*d.parameter, d.a)));
    }
    std::string text =
        fmt::format("Beside it runs B, with {}.\n", settings.empty() ? "the same parameters" : listed_words(settings));
    text += b.is_static() ? fmt::format("B stands at {}.\n", place_words(b.place()))
                          : fmt::format("B stands at {}, time {}.\n", place_words(b.place()), format_quantity(b.time(), "s"));
    if (!s.companion()->stopped().empty()) text += fmt::format("B has stopped: {}\n", s.companion()->stopped());
    for (const Probe* p : key_probes(a.lesson())) {
        if (s.hides(p->name)) continue;
        const auto of_a = number_of(a, *p), of_b = number_of(b, b.lesson().probe(p->name));
        if (!of_a && !of_b) continue;
        const auto said = [&](const auto& value) { return value ? format_quantity(*value, p->unit, 6) : "undefined"; };
        const std::string name = words(p->name);
        text += fmt::format("{} {} {} in A and {} in B", name, is_or_are(name), said(of_a), said(of_b));
        text += of_a && of_b ? fmt::format("; A − B is {}.\n", format_quantity(*of_a - *of_b, p->unit, 3)) : ".\n";
    }
    if (s.shows_difference()) text += "The picture shows A − B.\n";
    return text + fmt::format("The sliders set {}.\n", s.addresses_b() ? "B" : "A");
}

std::string pinned_sentence(const Session& s) {
    if (!s.pinned()) return "";
    std::vector<std::string> settings;
    for (std::size_t k = 0; k < s.lesson().parameters.size(); ++k) {
        const Parameter& p = *s.lesson().parameters[k];
        if (!s.hides(p.info.key) && s.runner().wanted(p) != s.pinned()->settings[k])
            settings.push_back(setting_words(p, s.pinned()->settings[k]));
    }
    return fmt::format("Pinned behind it is a run with {}.\n", settings.empty() ? "the same parameters" : listed_words(settings));
}

// The unfolded card, while the claims are in front.
std::string claim_sentences(const LabState& lab) {
    const Claim* c = lab.side == SideTab::claims ? lab.claims.book.unfolded(lab.session.entry().info.id) : nullptr;
    if (!c) return "";
    std::string text = fmt::format("Claim {}: {}\nThe question: {}", c->id, c->statement, c->question);
    for (std::size_t k = 0; k < c->answers.size(); ++k) text += fmt::format(" {}: {}.", k + 1, c->answers[k]);
    if (const auto chosen = lab.claims.book.prediction(*c)) text += fmt::format(" You chose {}.", *chosen + 1);
    text += "\n";
    const ClaimResult* r = lab.claims.book.result(*c);
    if (!r) return text + "It is not measured yet.\n";
    if (!r->finding) return text + r->failure + "\n";
    text += fmt::format("It is {}: {} is {}, criterion {}. {}\n", outcome_of(*r), c->figure, figure_text(*r), c->criterion,
                        r->finding->text);
    if (!r->finding->condition.empty()) text += fmt::format("Condition: {}\n", r->finding->condition);
    return text + fmt::format("The right answer is {}.\n", c->right_answer + 1);
}

// The map, while the atlas is in front.
std::string atlas_sentences(const LabState& lab) {
    const StabilityMap* map = lab.side == SideTab::atlas ? lab.atlas.atlas.map() : nullptr;
    if (!map) return "";
    std::string text = fmt::format("The atlas of {} and {}:", words(map->order.across.key), words(map->order.up.key));
    const char* comma = "";
    for (int k = 0; k < stability_kinds; ++k)
        if (const Index n = map->count(static_cast<Stability>(k)))
            text += fmt::format("{} {} {}", std::exchange(comma, ","), n, words_of(static_cast<Stability>(k)));
    return text + fmt::format(". {}\n", agreement_text(*map));
}

}  // namespace

std::string summary_of(const LabState& lab) {
    const Session& s = lab.session;
    std::string text = summary_text(s.runner(), [&](std::string_view name) { return s.hides(name); });
    text += s.playing ? "The run is playing.\n" : "The run is paused.\n";
    if (!s.inspector.stopped.empty()) text += fmt::format("It was stopped: {}.\n", s.inspector.stopped);
    text += beside_sentences(s);
    text += pinned_sentence(s);
    text += colours_sentence(s);
    text += thing_sentences(s);
    text += claim_sentences(lab);
    text += atlas_sentences(lab);
    if (s.walkthrough)
        text += fmt::format("Walkthrough, slide {} of {}: {}.\n", s.slide_number() + 1, s.slide_count(),
                            without_marks(s.walkthrough->slide().title));
    if (s.autopsy())
        text += s.autopsy()->text() + "\n";
    else if (s.message())
        text += fmt::format("Message: {}\n", s.message()->text);
    return text;
}

}  // namespace pliant::viewer
