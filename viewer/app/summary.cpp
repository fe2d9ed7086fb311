#include "app/summary.h"

#include <pliant/document/summary.h>
#include <pliant/study/stability_report.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <utility>

namespace pliant::viewer {
namespace {

std::string colours_sentence(const Session& s) {
    const Field* field = s.lesson().find_field(s.colours.field);
    if (!field || !field->in_use()) return "";
    const ColourScale& scale = s.colour_scale();
    return fmt::format("The picture shows {}, from {} to {}.\n", words(field->name), format_quantity(scale.min, field->unit, 3),
                       format_quantity(scale.max, field->unit, 3));
}

std::string thing_sentences(const Session& s) {
    const auto& thing = s.inspector.thing;
    if (!thing) return "";
    std::string text = fmt::format("Picked: {} {}.\n", name_of(thing->on), thing->index);
    for (const Field& f : s.lesson().fields) {
        if (!f.in_use() || f.on != thing->on || thing->index >= f.size()) continue;
        text += fmt::format("{}{} is {}", f.rank == Rank::scalar ? "" : "The size of ", words(f.name),
                            format_quantity(row_value(f, thing->index, -1), f.unit));
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
    std::string text = summary_text(s.runner());
    text += s.playing ? "The run is playing.\n" : "The run is paused.\n";
    if (!s.inspector.stopped.empty()) text += fmt::format("It was stopped: {}.\n", s.inspector.stopped);
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
