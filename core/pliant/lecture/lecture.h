// A lecture in one file: an ordered list of slides with words, formulas, pictures, scenes and slides of any lesson, claims and
// stability maps. It is JSON, or Markdown as a walkthrough is; the two say the same things by the same names.
//
//   {"pliant_lecture": 1, "title": "Soft bodies", "slides": [
//     {"title": "Why bodies give way", "minutes": 2, "text": ["A paragraph.", "Another one."], "formula": "σ = F / A"},
//     {"title": "A block falls", "lesson": "mesh/mass_spring", "set": {"cells_x": 6}, "field": "tension",
//      "ask": "…", "do": ["run 0.3 s"], "expect": ["stretch < 1e-9"], "answer": "…", "notes": "…", "controls": "gravity"},
//     {"deck": "mesh/mass_spring", "slides": ["Landing", 4]},
//     {"claim": "E6"}, {"title": "As I left it", "scene": "pliant1:…"}]}
//
//   # Soft bodies
//   ## A block falls
//   A paragraph.
//   ```show
//   lesson mesh/mass_spring
//   set cells_x=6
//   field tension
//   ```
//   ```ask
//   …
//   ```
//
// Keys of a slide; those of the last group stand in a ```show block of Markdown, a line each with the value behind the name:
//   title
//   text formula ask predict do expect answer hide plots notes controls     as in a walkthrough (walkthrough.h); a text or a list
//   of lines minutes    that it is to take lesson     opens it; with `preset` (a name), `set` (parameters), `field` (that colours
//   the picture) scene      opens a scene: an object as in a scene file, a share string, or the path of a scene file beside with
//   one of these: a second run, B, with these parameters set otherwise; a line of `expect` that begins with "B "
//              is about it
//   deck       a lesson, of whose walkthrough it shows `slides` (titles or numbers from 1; all when not given), one after the
//   other claim      the card of a claim, such as E6 atlas      with a lesson or scene: two knobs, across and up:
//   "time_step=1e-4:0.1:40:log" picture    the path of a PNG file fill       what fills the screen: picture, plot (or `plot NAME`
//   of a probe), matrix or atlas
// Paths are relative to the folder of the lecture.
#pragma once
#include <pliant/document/scene_file.h>
#include <pliant/document/walkthrough.h>
#include <pliant/study/map_knobs.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

// One slide of the walkthrough of a lesson, which plays it from its start up to there.
struct DeckSlide {
    std::string lesson;
    std::size_t number = 0;  // from 0
    bool operator==(const DeckSlide&) const = default;
};

// What fills the screen: "picture", "plot", "matrix" or "atlas", and of a plot its probe, or "" for the first one.
struct FilledPanel {
    std::string panel, probe;
    bool operator==(const FilledPanel&) const = default;
};

struct LectureSlide {
    Slide slide;                                   // its title, and blocks as in a walkthrough
    std::optional<SceneFile> scene{};              // that it opens
    std::optional<Runner::Assignments> beside{};   // what the second run, B, has otherwise
    std::optional<std::pair<Knob, Knob>> atlas{};  // across, up
    std::optional<DeckSlide> deck{};
    std::string claim{};    // its id
    std::string picture{};  // a path
    std::optional<FilledPanel> fill{};
    Real minutes = 0;       // 0: not said
    int line = 0;           // of the file, from 1
    std::string trouble{};  // "path:line: ..." why it cannot be shown; "" when it can

    // The lesson that it opens; "" when it shows words and pictures alone.
    std::string lesson() const;
};

struct Lecture {
    std::string path, title;
    std::vector<LectureSlide> slides;
    Real minutes() const;  // of all slides that say theirs
};

// A slide that names what is not there, or a scene that is refused, gets its trouble told; the others go on. Throws Refused, as
// "path:line:column: ..." or "path:line: ...", for a text that is no lecture.
Lecture parse_lecture(std::string_view text, std::string_view path);
// A file, or one of the lectures that come with Pliant by its name, "soft_bodies". Throws Refused with what there is.
Lecture read_lecture(const std::string& path);
// Is it a lecture rather than a scene, by its beginning? What is wrong in it comes out when it is read.
bool looks_like_lecture(std::string_view text);
std::vector<std::string> lecture_names();  // of those that come with Pliant

// The text of the lecture with a slide added at its end, as JSON or as Markdown, whichever the text is; a new lecture for an
// empty text. Everything else stays as it was written, but for blanks of JSON. Throws as parse_lecture.
std::string with_slide_added(std::string_view text, std::string_view path, const LectureSlide& slide);

// The slide alone as a walkthrough, for a player of its run, or of the second one.
Walkthrough walkthrough_of(const Lecture& lecture, const LectureSlide& slide, bool second_run = false);

// Plays the slide to its end: a scene to its place, its actions, what it expects; of a claim its measurement. Throws Refused with
// its trouble and for actions that are refused, and Diverged.
std::vector<ExpectationResult> played(const Lecture& lecture, std::size_t slide);

// The scene of a slide as it comes up, to be shared: of a deck, what its walkthrough has done up to there. Empty when it shows
// no lesson. Throws Refused and Diverged.
std::optional<SceneFile> scene_to_share(const Lecture& lecture, std::size_t slide);

// A page for those who listened: of each slide its words, its picture (a file beside the page, "" for none), its question and
// answer, and its scene as a share string. HTML, which also prints well; without the lecturer's notes.
std::string handout_html(const Lecture& lecture, const std::vector<std::string>& pictures);

}  // namespace pliant
