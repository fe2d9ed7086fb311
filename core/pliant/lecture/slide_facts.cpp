// What a slide of a lecture names is looked up: lessons, presets, scenes, slides of walkthroughs, claims, knobs and pictures.
#include <pliant/document/share.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/lecture/slide_facts.h>
#include <pliant/study/claims.h>
#include <pliant/text/number_text.h>
#include <pliant/text/suggest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>

namespace pliant {
namespace {

namespace fs = std::filesystem;
constexpr Real most_minutes = 600;

// Looks up one slide. Every refusal begins with the place of the fact that it is about.
class SlideMaker {
public:
    SlideMaker(const SlideFacts& said, std::string folder) : said_(said), folder_(std::move(folder)) {
        made_.slide = said.slide;
        made_.line = said.slide.line;
    }

    std::vector<LectureSlide> make() try {
        if (!said_.trouble.empty()) throw Refused(said_.trouble);
        check_together();
        take_minutes();
        take_scene();
        take_beside();
        take_claim();
        take_atlas();
        take_picture();
        take_fill();
        take_title();
        return take_deck();
    } catch (const Refused& e) {
        made_.trouble = e.what();
        if (made_.slide.title.empty()) made_.slide.title = "A slide that cannot be shown";
        return {made_};
    }

private:
    const SlideFact* fact(std::string_view key) const {
        const auto found = std::ranges::find(said_.facts, key, &SlideFact::key);
        return found == said_.facts.end() ? nullptr : &*found;
    }
    [[noreturn]] static void refuse(const SlideFact& f, const std::string& what) {
        throw Refused(fmt::format("{}: {}", f.place, what));
    }
    // Adds the place to what is refused elsewhere.
    template <class Look>
    static auto at(const SlideFact& f, Look look) {
        try {
            return look();
        } catch (const Refused& e) {
            refuse(f, e.what());
        }
    }
    static const std::string& only_value(const SlideFact& f) {
        if (f.is_object || f.values.size() != 1 || f.values[0].empty())
            refuse(f, fmt::format("'{}' takes one value, not {}", f.key,
                                  f.is_object        ? "an object"
                                  : f.values.empty() ? "none"
                                                     : "several"));
        return f.values[0];
    }

    // A slide opens one thing; what belongs to a scene needs one.
    void check_together() const {
        static constexpr std::array opens{"lesson", "scene", "deck", "claim"};
        const SlideFact* first = nullptr;
        for (const char* key : opens) {
            const SlideFact* f = fact(key);
            if (f && first)
                refuse(*f, fmt::format("a slide opens one of {}: '{}' stands there already", fmt::join(opens, ", "), first->key));
            if (f) first = f;
        }
        const std::string_view opened = first ? std::string_view(first->key) : "";
        for (const char* key : {"preset", "set", "field"})
            if (const SlideFact* f = fact(key); f && opened != "lesson")
                refuse(*f, fmt::format("'{}' needs 'lesson' on the same slide", key));
        for (const char* key : {"beside", "atlas"})
            if (const SlideFact* f = fact(key); f && opened != "lesson" && opened != "scene")
                refuse(*f, fmt::format("'{}' needs 'lesson' or 'scene' on the same slide", key));
        if (const SlideFact* f = fact("slides"); f && opened != "deck")
            refuse(*f, "'slides' needs 'deck' on the same slide: the lesson whose slides are meant");
        if (const SlideFact* f = fact("fill"); f && opened.empty() && !fact("picture"))
            refuse(*f, "there is nothing that could fill the screen: give a lesson, scene, claim, deck or picture");
        for (const Block& b : said_.slide.blocks)
            if ((b.kind == BlockKind::actions || b.kind == BlockKind::expect || b.kind == BlockKind::predict ||
                 b.kind == BlockKind::controls) &&
                opened != "lesson" && opened != "scene")
                throw Refused(fmt::format("{}: '{}' needs 'lesson' or 'scene' on the same slide", said_.place, name_of(b.kind)));
    }

    void take_minutes() {
        const SlideFact* f = fact("minutes");
        if (!f) return;
        const auto minutes = finite_number(only_value(*f));
        if (!minutes || *minutes <= 0 || *minutes > most_minutes)
            refuse(*f, fmt::format("minutes = {}: a number above 0, up to {:g}", only_value(*f), most_minutes));
        made_.minutes = *minutes;
    }

    void take_scene() {
        if (const SlideFact* f = fact("lesson")) {
            const LessonEntry& entry = at(*f, [&]() -> const LessonEntry& { return find_lesson(only_value(*f)); });
            SceneFile scene{.lesson = std::string(entry.info.id), .parameters = {}};
            if (const SlideFact* p = fact("preset")) scene = at(*p, [&] { return preset(entry, only_value(*p)); });
            if (const SlideFact* s = fact("set")) at(*s, [&] { set(scene, settings(*s)); });
            if (const SlideFact* s = fact("field")) at(*s, [&] { show(scene, entry, only_value(*s)); });
            made_.scene = std::move(scene);
        } else if (const SlideFact* g = fact("scene")) {
            made_.scene = g->is_object ? parse_scene(g->values[0], said_.path) : at(*g, [&] { return scene_said(*g); });
        }
        if (!made_.scene) return;
        const SlideFact& f = *(fact("lesson") ? fact("lesson") : fact("scene"));
        at(f, [&] { Runner::check(find_lesson(made_.scene->lesson), made_.scene->parameters, made_.scene->events); });
    }
    static void show(SceneFile& scene, const LessonEntry& entry, const std::string& field) {
        const Runner runner(entry, scene.parameters, 0);
        scene.view.emplace().field = runner.lesson().field(field).name;
    }
    // Later ones win, and all are checked at once.
    static void set(SceneFile& scene, const Runner::Assignments& more) {
        scene.parameters.insert(scene.parameters.end(), more.begin(), more.end());
        Runner::check(find_lesson(scene.lesson), scene.parameters, scene.events);
    }
    SceneFile scene_said(const SlideFact& f) const {
        const std::string& text = only_value(f);
        return is_share(text) ? read_share(text) : read_scene((fs::path(folder_) / text).string());
    }
    static Runner::Assignments settings(const SlideFact& f) {
        std::vector<std::string> words{f.key};
        for (const std::string& value : f.values)
            for (std::string& word : words_of_line(value)) words.push_back(std::move(word));
        if (words.size() == 1) refuse(f, fmt::format("'{}' is empty: give KEY=VALUE", f.key));
        return assignments_of(words);
    }

    void take_beside() {
        const SlideFact* f = fact("beside");
        if (!f) return;
        at(*f, [&] {
            SceneFile second = *made_.scene;
            made_.beside = settings(*f);
            set(second, *made_.beside);
        });
    }

    void take_claim() {
        if (const SlideFact* f = fact("claim")) made_.claim = at(*f, [&] { return find_claim(only_value(*f)).id; });
    }

    void take_atlas() {
        const SlideFact* f = fact("atlas");
        if (!f) return;
        std::vector<std::string> words;
        for (const std::string& value : f->values)
            for (std::string& word : words_of_line(value)) words.push_back(std::move(word));
        if (words.size() != 2)
            refuse(
                *f,
                "an atlas takes two knobs, across and up, such as \"time_step=1e-4:0.1:40:log\" and \"damping_ratio=0:1.5:40\"");
        at(*f, [&] {
            const Runner runner(find_lesson(made_.scene->lesson), made_.scene->parameters, 0);
            made_.atlas.emplace(parse_knob(runner.lesson(), words[0]), parse_knob(runner.lesson(), words[1]));
            if (made_.atlas->first.key == made_.atlas->second.key) throw Refused("the two knobs of an atlas are different ones");
        });
    }

    void take_picture() {
        const SlideFact* f = fact("picture");
        if (!f) return;
        const fs::path path = fs::path(folder_) / only_value(*f);
        std::error_code error;
        if (!fs::is_regular_file(path, error))
            refuse(*f, fmt::format("there is no picture {}: give the path of a PNG file, from the folder of the lecture",
                                   path.string()));
        if (path.extension() != ".png") refuse(*f, fmt::format("{} is no .png file: pictures are PNG", path.string()));
        made_.picture = path.string();
    }

    void take_fill() {
        const SlideFact* f = fact("fill");
        if (!f) return;
        const auto words = words_of_line(only_value(*f));
        static constexpr std::array panels{"picture", "plot", "matrix", "atlas"};
        if (words.empty() || words.size() > 2 || std::ranges::find(panels, words[0]) == panels.end() ||
            (words.size() == 2 && words[0] != "plot"))
            refuse(*f,
                   fmt::format("fill = {}: one of {}, or plot and the name of a probe", only_value(*f), fmt::join(panels, ", ")));
        if (words[0] == "atlas" && !made_.atlas) refuse(*f, "the atlas fills the screen where 'atlas' gives its knobs");
        made_.fill = FilledPanel{words[0], words.size() == 2 ? words[1] : ""};
        if (words.size() == 2 && words[1] != "cost") at(*f, [&] { find_lesson(made_.lesson()).make()->probe(words[1]); });
    }

    void take_title() {
        if (!made_.slide.title.empty()) return;
        if (!made_.claim.empty())
            made_.slide.title = fmt::format("Claim {}", made_.claim);
        else if (made_.scene)
            made_.slide.title = find_lesson(made_.scene->lesson).info.title;
        else if (!fact("deck"))
            throw Refused(fmt::format("{}: the slide has no title", said_.place));
    }

    std::vector<LectureSlide> take_deck() {
        const SlideFact* f = fact("deck");
        if (!f) return {made_};
        const LessonEntry& entry = at(*f, [&]() -> const LessonEntry& { return find_lesson(only_value(*f)); });
        const Walkthrough walkthrough = at(*f, [&] { return pliant::walkthrough_of(entry); });
        std::vector<LectureSlide> all;
        for (const std::size_t n : numbers(entry, walkthrough)) {
            LectureSlide s = made_;
            s.deck = DeckSlide{std::string(entry.info.id), n};
            s.slide = with_additions(walkthrough.slides[n]);
            all.push_back(std::move(s));
        }
        for (LectureSlide& s : all) s.minutes /= static_cast<Real>(all.size());
        return all;
    }
    // The slide of the walkthrough; words and notes of the lecture's own stand before it, and a title takes its place.
    Slide with_additions(const Slide& of_deck) const {
        Slide s = of_deck;
        s.line = said_.slide.line;
        if (!said_.slide.title.empty()) s.title = said_.slide.title;
        s.blocks.insert(s.blocks.begin(), said_.slide.blocks.begin(), said_.slide.blocks.end());
        return s;
    }
    std::vector<std::size_t> numbers(const LessonEntry& entry, const Walkthrough& w) const {
        std::vector<std::size_t> result;
        const SlideFact* f = fact("slides");
        for (std::size_t n = 0; !f && n < w.slides.size(); ++n) result.push_back(n);
        if (!f) return result;
        for (const std::string& name : f->values) result.push_back(number(*f, entry, w, name));
        if (result.empty()) refuse(*f, "'slides' names none: give titles or numbers, or leave it out for all");
        return result;
    }
    static std::size_t number(const SlideFact& f, const LessonEntry& entry, const Walkthrough& w, const std::string& name) {
        if (const auto n = whole_number(name)) {
            if (*n >= 1 && static_cast<std::size_t>(*n) <= w.slides.size()) return static_cast<std::size_t>(*n - 1);
            refuse(f, fmt::format("slide {} is not there: the walkthrough of {} has slides 1 to {}", name, entry.info.id,
                                  w.slides.size()));
        }
        std::vector<std::string> titles;
        for (const Slide& s : w.slides) titles.push_back(s.title);
        const auto found = std::ranges::find(titles, name);
        if (found == titles.end())
            refuse(f, fmt::format("the walkthrough of {} has no slide '{}'{}; there are: {}", entry.info.id, name,
                                  did_you_mean(name, titles), fmt::join(titles, " · ")));
        return static_cast<std::size_t>(found - titles.begin());
    }

    const SlideFacts& said_;
    std::string folder_;
    LectureSlide made_;
};

}  // namespace

const std::vector<std::string>& slide_fact_keys() {
    static const std::vector<std::string> keys{"minutes", "lesson", "preset", "set",   "field",   "scene", "beside",
                                               "deck",    "slides", "claim",  "atlas", "picture", "fill"};
    return keys;
}

std::vector<LectureSlide> lecture_slides(const SlideFacts& said, const std::string& folder) {
    return SlideMaker(said, folder).make();
}

}  // namespace pliant
