// What the session shows: its pictures, which are kept until something that they depend on changes, and their colours.
#include "session/session.h"

#include "render/ghost.h"
#include "session/drawn_run.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pliant::viewer {

namespace {
bool has_both_signs(const Field& field, int component) { return field.rank == Rank::scalar ? field.both_signs : component >= 0; }

// Of the largest of its components: beside it another one may be rounding alone.
Real size_of(const Field& field) {
    Real size = 0;
    for (const Real number : field.view()) size = std::max(size, std::abs(number));
    return size;
}
}  // namespace

std::vector<Real> Session::shown_values() const {
    const Field* field = lesson().find_field(colours.field);
    std::vector<Real> values;
    if (!field || !field->in_use()) return values;
    row_values(*field, colours.component, values);
    if (shows_difference()) {
        values = difference();
    } else if (const Field* beside = companion_ ? companion_->lesson().find_field(colours.field) : nullptr;
               beside && beside->in_use() && companion_->stopped().empty()) {
        std::vector<Real> of_b;
        row_values(*beside, colours.component, of_b);
        values.insert(values.end(), of_b.begin(), of_b.end());
    }
    return values;
}

void Session::view_changed() {
    if (put_off([this] { view_changed(); })) return;
    const Field* field = lesson().find_field(colours.field);
    shows_change_ = false;
    if (!field || !field->in_use()) return;
    const Real size = size_of(*field);
    if (const auto shown = std::tuple(colours.field, colours.component, shows_difference());
        std::exchange(ranged_, shown) != shown)
        range.forget_size(), change_range_.forget_size();
    range.update(shown_values(), shows_difference() || has_both_signs(*field, colours.component), size);
    if (inspector.compare != Compare::difference) return;
    guarded([&] { inspector.renew_trace(*runner_); });
    if (const auto change = inspector.change(*runner_, *field, colours.component)) {
        change_range_.update(*change, true, size);
        shows_change_ = true;
    }
}

Camera Session::seen_by() const {
    if (!camera) return viewpoint.camera();
    Camera seen = *camera;
    if (own_aspect_ > aspect_ && aspect_ > 0) seen.distance *= Real{own_aspect_} / Real{aspect_};
    return seen;
}

void Session::see_in(float aspect) {
    aspect_ = aspect;
    if (!camera) own_aspect_ = 0;
    if (camera && own_aspect_ == 0) own_aspect_ = aspect;
}

Camera& Session::own_camera() {
    camera = seen_by();
    own_aspect_ = aspect_;
    return *camera;
}

Scene Session::drawn() const {
    Scene picture;
    picture.colour_by = colours;
    picture.show_arrows = show_arrows, picture.show_labels = show_labels && !hides("labels");
    if (shows_difference()) picture.override_values = difference();
    return picture;
}

PictureKey Session::picture_key() const {
    return {.opened = open_count_,
            .revision = runner_->revision(),
            .beside_opened = companion_count_,
            .beside_revision = companion_ ? companion_->runner().revision() : -1,
            .pinned = pin_count_,
            .field = colours.field,
            .component = colours.component,
            .arrows = show_arrows,
            .labels = show_labels && !hides("labels"),
            .smooth = smooth,
            .difference = shows_difference(),
            .change = shows_change_,
            .compare = inspector.compare,
            .stage = inspector.stage};
}

// The picture that is kept, or another one where something has changed since.
const KeptPicture& Session::kept(Keeping& keeping, const std::function<bool(Scene&)>& draw) {
    PictureKey key = picture_key();
    if (keeping.key && shows_last_step())
        key.revision = keeping.key->revision, key.beside_revision = keeping.key->beside_revision;
    const bool same_lesson = keeping.key && keeping.key->opened == key.opened;
    if (keeping.key == key || (holding_ && same_lesson)) return keeping.picture;
    Scene scene = drawn();
    keeping.picture = nullptr;
    if (draw(scene)) {
        for (GridMarks& g : scene.grids) g.smooth = g.smooth && smooth;
        keeping.picture = std::make_shared<const Picture>(std::move(scene), ++pictures_drawn_);
    }
    keeping.key = std::move(key);
    return keeping.picture;
}

void Session::prepare_pictures() {
    picture();
    other_picture();
    picture_beside();
}

KeptPicture Session::picture() {
    if (inspector.compare == Compare::before)
        if (KeptPicture before = other_picture()) return before;
    return kept(now_, [this](Scene& scene) {
        const Field* field = lesson().find_field(colours.field);
        if (shows_change_ && field) scene.override_values = inspector.change(*runner_, *field, colours.component);
        draw_run(*runner_, scene);
        if (pinned_) lay_under(scene, pinned_->ghost);
        return true;
    });
}

KeptPicture Session::other_picture() {
    if (inspector.compare == Compare::now || inspector.compare == Compare::difference) return nullptr;
    return kept(before_, [this](Scene& scene) {
        bool found = false;
        guarded([&] { found = inspector.draw_before(*runner_, scene); });
        return found;
    });
}

KeptPicture Session::picture_beside() {
    if (!companion_) return nullptr;
    return kept(beside_, [this](Scene& scene) {
        draw_run(companion_->runner(), scene);
        return true;
    });
}

}  // namespace pliant::viewer
