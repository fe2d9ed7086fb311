#include "app/lecture_slide.h"

#include "panels/deck_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace pliant::viewer {
namespace {

bool has_words(const Slide& s) {
    return std::ranges::any_of(s.blocks, [](const Block& b) {
        return b.kind == BlockKind::text || b.kind == BlockKind::formula || b.kind == BlockKind::ask ||
               b.kind == BlockKind::answer;
    });
}

constexpr float words_beside = 0.36f, words_alone = 0.76f;  // of the width

}  // namespace

ShownBySlide shown_by_slide(const LabState& lab) {
    const LectureSlide* s = lab.session.lecture_slide();
    if (!s) return ShownBySlide::run;
    if (!s->trouble.empty()) return ShownBySlide::words;
    if (!s->claim.empty()) return ShownBySlide::claim;
    if (s->atlas) return ShownBySlide::atlas;
    if (!s->picture.empty()) return ShownBySlide::picture;
    return s->lesson().empty() ? ShownBySlide::words : ShownBySlide::run;
}

bool slide_has_words(const LabState& lab) { return has_words(lab.session.walkthrough->slide()); }

void place_without_run(const LabState& lab, DeckPlaces& p, const Rectangle& room) {
    const ShownBySlide shown = shown_by_slide(lab);
    if (shown == ShownBySlide::words) {
        const float width = words_alone * room.width;
        p.words = {(room.width - width) / 2, room.y + 0.06f * room.height, width, 0.94f * room.height};
        return;
    }
    const bool words = slide_has_words(lab);
    const float left = words ? words_beside * room.width : 0;
    p.words = words ? Rectangle{0, room.y, left, room.height} : Rectangle{};
    p.other = {left, room.y, room.width - left, room.height};
}

namespace {
// A list has none: its parameter is mapped over what its slider spans, or over its options.
std::optional<Atlas::Span> span_of(const Knob& knob) {
    if (knob.spacing == Spacing::list) return std::nullopt;
    return Atlas::Span{{knob.values.front(), knob.values.back()}, knob.spacing == Spacing::log};
}

// Is there a map, and is it of these knobs and parameters?
bool is_mapped(const LabState& lab) {
    const Atlas& atlas = lab.atlas.atlas;
    const StabilityMap* map = atlas.map();
    return map && !atlas.outdated(lab.session) && map->order.across.key == atlas.across && map->order.up.key == atlas.up;
}

std::string key_of_slide(const LabState& lab) {
    return fmt::format("{} {}", lab.session.lecture()->path, lab.session.slide_number());
}

// The map that there is, when it is whole and that of the slide.
void keep_map(LabState& lab) {
    AtlasPanelState& panel = lab.atlas;
    if (std::exchange(panel.kept_made, panel.atlas.made()) == panel.atlas.made()) return;
    if (panel.atlas.map() && panel.atlas.map()->complete && is_mapped(lab))
        panel.kept.insert_or_assign(key_of_slide(lab), *panel.atlas.map());
}

void begin_atlas(LabState& lab, const std::pair<Knob, Knob>& knobs) {
    AtlasPanelState& panel = lab.atlas;
    Atlas& atlas = panel.atlas;
    atlas.follow(lab.session);
    atlas.across = knobs.first.key, atlas.up = knobs.second.key;
    atlas.across_span = span_of(knobs.first), atlas.up_span = span_of(knobs.second);
    atlas.cells = static_cast<Index>(std::max(knobs.first.values.size(), knobs.second.values.size()));
    lab.side_wanted = SideTab::atlas;
    panel.unmade.reset();
    try {
        panel.unmade = std::make_unique<StabilityMap>(atlas.unmade(lab.session));
    } catch (const Refused&) {
        // What is wrong is told when it is to be made.
    }
    if (const auto kept = panel.kept.find(key_of_slide(lab)); kept != panel.kept.end() && !is_mapped(lab))
        atlas.show(kept->second);
}

}  // namespace

void draw_shown_by_slide(LabState& lab) {
    const LectureSlide& s = *lab.session.lecture_slide();
    switch (shown_by_slide(lab)) {
        case ShownBySlide::claim:
            return draw_claim_slide(lab, lab.claims, find_claim(s.claim));
        case ShownBySlide::atlas:
            return draw_atlas_of_slide(lab, lab.atlas, is_mapped(lab));
        case ShownBySlide::picture:
            return draw_slide_picture(lab, lab.slide_pictures, s.picture);
        case ShownBySlide::words:
        case ShownBySlide::run:
            return;
    }
}

namespace {
// A plot without a name is the first one of the scene.
Fill fill_of_slide(const LabState& lab, const LectureSlide& s) {
    if (!s.fill || !s.trouble.empty()) return {};
    if (s.fill->panel != "plot") return fill_from(s.fill->panel);
    return {Filled::plot, s.fill->probe.empty() ? first_plot_of_scene(lab.session.lesson()) : s.fill->probe};
}
}  // namespace

void begin_lecture_slide(LabState& lab) {
    const LectureSlide* s = lab.session.lecture_slide();
    if (!s) return;
    lab.fill = fill_of_slide(lab, *s);
    if (!s->trouble.empty()) return;
    if (!s->claim.empty()) lab.claims.book.unfold(find_claim(s->claim));
    if (s->atlas) begin_atlas(lab, *s->atlas);
}

void keep_of_lecture_slide(LabState& lab) {
    const LectureSlide* s = lab.session.lecture_slide();
    if (s && s->atlas && s->trouble.empty()) keep_map(lab);
}

bool next_shows_more(const LabState& lab) {
    const LectureSlide* s = lab.session.lecture_slide();
    if (!s || !s->trouble.empty()) return false;
    if (!s->claim.empty()) {
        const ClaimBook::Phase phase = lab.claims.book.phase(find_claim(s->claim));
        return phase == ClaimBook::Phase::asked || phase == ClaimBook::Phase::predicted;
    }
    return s->atlas && !lab.atlas.atlas.busy() && !is_mapped(lab);
}

bool show_more_of_slide(LabState& lab) {
    if (!next_shows_more(lab)) return false;
    const LectureSlide& s = *lab.session.lecture_slide();
    s.claim.empty() ? start_atlas(lab, lab.atlas) : lab.claims.book.measure(find_claim(s.claim));
    return true;
}

}  // namespace pliant::viewer
