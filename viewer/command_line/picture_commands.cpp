// `pliant shot` and `pliant tour`: pictures without a display.
#include <pliant/document/report.h>
#include <pliant/text/file.h>
#include <pliant/text/texts.h>

#include "app/lab.h"
#include "command_line/options.h"
#include "command_line/output_paths.h"
#include "command_line/pictures.h"
#include "command_line/terminal.h"
#include "platform/image.h"
#include "platform/png_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

namespace pliant::viewer {
namespace {

std::unique_ptr<Context> headless(const std::string& backend, Size size) {
    if (backend == "any") return open_headless(size);
    if (backend == "osmesa") return open_context(Backend::osmesa, size);
    if (backend == "egl") return open_context(Backend::egl, size);
    throw Refused(fmt::format("--backend {} is not accepted: give any, osmesa or egl", backend));
}

int animate(Lab& lab, Context& context, Animation& animation, const std::string& path) {
    animation.add(capture(lab, context));
    lab.session().playing = true;
    while (!animation.complete()) {
        animation.advance(lab.session());
        // Nothing moves while the frame is drawn.
        const bool playing = std::exchange(lab.session().playing, false);
        animation.add(capture(lab, context));
        lab.session().playing = playing;
    }
    write_file(path, animation.encoded());
    return 0;
}

void choose_view(Session& session, const PictureOptions& o) {
    if (!o.field.empty() || o.component != -1) {
        const Field& field = session.lesson().field(o.field.empty() ? session.colours.field : o.field);
        if (o.component < -1 || o.component >= field.components)
            throw Refused("--component", o.component, "",
                          fmt::format("a number from 0 to {}, or -1 for the whole", field.components - 1));
        session.colours = {std::string(field.name), o.component};
        session.range = {};
    }
    if (!o.stage.empty()) session.runner().run_to_stage(o.stage);
    session.view_changed();
}

bool of_slide(Layout layout) { return layout == Layout::deck || layout == Layout::presenter; }

// A slide makes its own run.
void check_deck(const RunOptions& run, const PictureOptions& picture) {
    if (!run.scene_path.empty() || !run.preset.empty() || !run.settings.empty() || run.steps || run.time || run.rest ||
        !picture.stage.empty())
        throw Refused(
            "--layout deck, or presenter, shows a slide of the walkthrough, which sets and runs the lesson itself: leave out "
            "--scene, --preset, "
            "--set, --steps, --time, --rest and --stage");
    if (picture.slide && *picture.slide < 1)
        throw Refused("--slide", static_cast<Real>(*picture.slide), "", "a number from 1 on");
}

// What both runs of a picture, or its walkthrough, set without effect: once a key.
std::vector<UnusedSetting> unused_in(const SceneFile& scene, const PictureOptions& picture, Layout layout) {
    const LessonEntry& entry = find_lesson(scene.lesson);
    if (of_slide(layout) && !scene.slide) return unused_settings(entry, walkthrough_of(entry));
    std::vector<UnusedSetting> unused = unused_settings(scene);
    if (picture.beside.empty()) return unused;
    SceneFile second = scene;
    for (auto& setting : assignments_from(picture.beside, "--beside")) second.parameters.push_back(std::move(setting));
    for (UnusedSetting& u : unused_settings(second))
        if (std::ranges::find(unused, u.key, &UnusedSetting::key) == unused.end()) unused.push_back(std::move(u));
    return unused;
}

// The picture's own, where the scene is of the first version.
Layout layout_of(const SceneFile& scene) {
    return scene.version() < 2 ? Layout::slide : layout_from(scene.layout.value_or(SceneLayout{}).layout);
}

// The card of a claim, measured.
void check_claim(const PictureOptions& o, Layout layout) {
    if (o.claim.empty()) return;
    find_claim(o.claim);
    if (layout != Layout::lab) throw Refused("--claim shows a card of the lab: give --layout lab as well");
}

void show_claim(LabState& lab, const std::string& id) {
    const Claim& c = find_claim(id);
    lab.claims.book.all = c.lesson != lab.session.entry().info.id;
    lab.claims.book.unfold(c);
    lab.claims.book.measure_now(c);
    lab.side_wanted = SideTab::claims, lab.claims.reveal = true;
}

// The map of the lesson's first knobs.
void show_atlas(LabState& lab) {
    lab.atlas.atlas.follow(lab.session);
    lab.atlas.atlas.make_now(lab.session);
    lab.side_wanted = SideTab::atlas;
}

void show_filled(Lab& lab, const PictureOptions& o) {
    if (o.fill.empty()) return;
    const Fill fill = fill_from(o.fill);
    if (fill.what == Filled::plot && !has_plot(lab.state(), fill.plot))
        throw Refused(
            fmt::format("--fill: the scene of {} has no plot '{}': give the name of a probe or of a line, as `pliant describe` "
                        "lists them",
                        lab.session().entry().info.id, fill.plot));
    if (fill.what == Filled::atlas) show_atlas(lab.state());
    lab.state().fill = fill;
}

void check_writable_picture(const PictureOptions& o) {
    require_ending("--out", o.out, {".png", ".gif"}, "a picture is written as PNG, with --seconds as an animated GIF");
    if (!is_special_file(o.out) && (ending_of(o.out) == ".gif") != (o.seconds != 0))
        throw Refused("an animation needs both: --out with a name that ends in .gif, and --seconds, from 1 to 30");
    check_writable(o.out);
}

struct TourStop {
    std::string name, title;
    SceneFile scene;
};

std::vector<TourStop> stops_of(const LessonEntry& entry) {
    std::string name(entry.info.id);
    std::ranges::replace(name, '/', '_');
    std::vector<TourStop> stops{{name, std::string(entry.info.title), {.lesson = std::string(entry.info.id), .parameters = {}}}};
    for (const std::string& p : preset_names(entry.info.id))
        stops.push_back({name + "_" + p, fmt::format("{}: {}", entry.info.title, words(p)), preset(entry, p)});
    return stops;
}

// Runs one scene of the tour; its picture is also that of a run which diverges, at its last good state.
std::string visit(Lab& lab, Context& context, const TourStop& stop, const std::filesystem::path& folder) {
    Session& s = lab.session();
    lab.open_scene(stop.scene);
    try {
        s.run(s.runner().is_static() ? Until::at_rest() : Until::after_steps(s.entry().info.demo_steps));
    } catch (const Diverged& e) {
        s.tell(e);
    }
    lab.state().layout = Layout::slide;
    write_png(capture(lab, context), (folder / (stop.name + ".png")).string());
    write_file((folder / (stop.name + ".csv")).string(), s.recorder().csv(s.lesson()));
    write_file((folder / (stop.name + ".json")).string(), run_json(s.runner(), unused_settings(stop.scene)));
    return fmt::format(
        "<section><h2>{}</h2><p>{}</p><a href=\"{}.png\"><img src=\"{}.png\" alt=\"{}\"></a><p><a href=\"{}.csv\">probes as "
        "CSV</a> · <a href=\"{}.json\">all figures as JSON</a></p></section>\n",
        stop.title, s.entry().info.summary, stop.name, stop.name, stop.title, stop.name, stop.name);
}

void visit_lab(Lab& lab, Context& context, const std::string& name, const std::filesystem::path& folder) {
    lab.state().layout = Layout::lab;
    lab.session().camera.reset();
    write_png(capture(lab, context), (folder / (name + "_lab.png")).string());
}

constexpr std::string_view page_head = R"(<!doctype html><html lang="en"><meta charset="utf-8"><title>A tour of Pliant</title>
<style>body{font:16px/1.5 "DejaVu Sans",sans-serif;max-width:1000px;margin:2em auto;padding:0 1em}img{width:100%;border:1px solid #999}</style>
<h1>A tour of Pliant</h1>
)";

}  // namespace

Image capture(Lab& lab, Context& context) {
    for (int i = 0; i < 3; ++i) {
        if (i) context.present();
        lab.frame(0);
    }
    Image image = read_pixels(context);
    context.present();
    return image;
}

void show_slide(Session& s, std::size_t n, bool revealed) {
    walkthrough_of(s.entry());
    s.start_walkthrough();
    s.go_to_slide(n);
    if (revealed && !s.message()) s.walkthrough_next();
    if (s.message() && !s.autopsy()) throw Refused(s.message()->text);
}

int shot(const RunOptions& options, const PictureOptions& picture) {
    const SceneFile scene = scene_from(options);
    const Size size = size_from(picture.size);
    const Theme theme = theme_from(picture.theme);
    const Layout layout = picture.layout.empty() ? layout_of(scene) : layout_from(picture.layout);
    if (of_slide(layout) && !scene.slide) check_deck(options, picture);
    if (!of_slide(layout) && (picture.slide || picture.revealed))
        throw Refused("--slide and --revealed show a slide of the walkthrough: give --layout deck or presenter as well");
    check_claim(picture, layout);
    fill_from(picture.fill);
    if (picture.atlas && layout != Layout::lab) throw Refused("--atlas shows a panel of the lab: give --layout lab as well");
    if (picture.atlas && !picture.claim.empty()) throw Refused("give --claim or --atlas: the lab shows one of them");
    const float scale = ui_scale_from(picture.ui_scale);
    if (of_slide(layout) && !picture.beside.empty())
        throw Refused("--beside shows two runs, and a slide of the walkthrough has one: leave out --layout");
    if (picture.difference && picture.beside.empty())
        throw Refused("--difference needs a second run: give --beside KEY=VALUE as well");
    check_writable_picture(picture);
    tell_unused(unused_in(scene, picture, layout), options.strict);
    std::optional<Animation> animation;
    if (picture.seconds != 0) animation.emplace(picture.seconds, picture.frames_per_second, size.width);
    const auto context = headless(picture.backend, size);
    Lab lab(*context, scene.lesson);
    lab.set_theme(theme);
    lab.set_scale(scale);
    lab.state().layout = layout;
    lab.state().scene.hints_shown = false;
    Session& s = lab.session();
    SceneFile opened = scene;
    if (!runs_to_place(options, scene)) opened.place.reset();
    lab.open_scene(opened);
    lab.state().layout = layout;
    if (const auto& told = s.message(); told && told->kind == Session::Message::Kind::refused) throw Refused(told->text);
    if (!picture.beside.empty()) s.open_companion(assignments_from(picture.beside, "--beside"));
    s.patterns = s.patterns || picture.patterns;
    if (!picture.claim.empty()) show_claim(lab.state(), picture.claim);
    if (picture.atlas) show_atlas(lab.state());
    const bool from_start = animation && !options.steps && !options.time && !options.rest;
    std::optional<Diverged> divergence;
    try {
        if (of_slide(layout) && !scene.slide)
            show_slide(s, static_cast<std::size_t>(picture.slide.value_or(1) - 1), picture.revealed);
        else if (!runs_to_place(options, scene))
            s.run(from_start ? Until::after_steps(0) : until_from(options, s.entry(), s.runner().is_static()));
        choose_view(s, picture);
    } catch (const Diverged& e) {
        if (animation) throw;
        // The picture is that of the last good state, with what went wrong over it.
        divergence = e;
        s.tell(e);
    }
    if (picture.difference) s.show_difference(true);
    if (picture.difference && !s.shows_difference()) throw Refused(s.message()->text);
    show_filled(lab, picture);
    if (animation) return animate(lab, *context, *animation, picture.out);
    write_png(capture(lab, *context), picture.out);
    if (divergence) throw *divergence;
    return s.autopsy() ? static_cast<int>(ExitCode::diverged) : 0;
}

std::vector<const LessonEntry*> lessons_of_tour(const std::vector<std::string>& names) {
    std::vector<const LessonEntry*> entries;
    for (const std::string& name : names) entries.push_back(&find_lesson(name));
    if (names.empty())
        for (const LessonEntry& entry : lessons()) entries.push_back(&entry);
    return entries;
}

int tour(const std::string& folder_name, const std::vector<std::string>& names, bool strict) {
    const auto entries = lessons_of_tour(names);
    const std::filesystem::path folder(folder_name);
    refuse_file_ending("--out", folder_name);
    make_folder(folder);
    for (const LessonEntry* entry : entries)
        for (const TourStop& stop : stops_of(*entry)) tell_unused(unused_settings(stop.scene), strict);
    std::string page(page_head);
    const auto slide_context = open_headless({1280, 720});
    {
        Lab lab(*slide_context);
        lab.state().scene.hints_shown = false;
        for (const LessonEntry* entry : entries)
            for (const TourStop& stop : stops_of(*entry)) {
                tell(stop.name);
                page += visit(lab, *slide_context, stop, folder);
                visit_lab(lab, *slide_context, stop.name, folder);
            }
    }
    write_file((folder / "index.html").string(), page + "</html>\n");
    print((folder / "index.html").string() + "\n");
    return 0;
}

}  // namespace pliant::viewer
