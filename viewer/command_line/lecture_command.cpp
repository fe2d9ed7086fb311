// `pliant lecture F`: what is in it, checked, shown in a window, or as pictures, a PDF file and a handout.
#include <pliant/lecture/lecture.h>
#include <pliant/text/file.h>
#include <pliant/text/spoken.h>

#include "command_line/options.h"
#include "command_line/output_paths.h"
#include "command_line/pictures.h"
#include "command_line/terminal.h"
#include "platform/headless_context.h"
#include "platform/pdf_file.h"
#include "platform/png_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace pliant::viewer {
namespace {

std::string minutes_text(Real minutes) { return minutes > 0 ? fmt::format("{:g} min", minutes) : ""; }

std::string shown_by(const LectureSlide& s) {
    if (!s.trouble.empty()) return "cannot be shown";
    if (s.deck) return fmt::format("slide {} of {}", s.deck->number + 1, s.deck->lesson);
    if (!s.claim.empty()) return fmt::format("claim {}", s.claim);
    if (s.atlas) return fmt::format("stability map of {}", s.scene->lesson);
    if (s.scene) return fmt::format("{}{}", s.scene->lesson, s.beside ? ", two runs" : "");
    return s.picture.empty() ? "words" : "picture";
}

void print_outline(const Lecture& lecture) {
    print(fmt::format("{}\n\n", lecture.title));
    for (std::size_t n = 0; n < lecture.slides.size(); ++n) {
        const LectureSlide& s = lecture.slides[n];
        print(fmt::format("{:3}  {:>7}  {}: {}\n", n + 1, minutes_text(s.minutes), s.slide.title, shown_by(s)));
        if (!s.trouble.empty()) print(fmt::format("              {}\n", s.trouble));
    }
    print(fmt::format("\n{}, {:g} min planned\n", counted(static_cast<long long>(lecture.slides.size()), "slide"),
                      lecture.minutes()));
}

struct Checked {
    int met = 0, missed = 0, refused = 0;
    std::string troubles, misses;
};

void check_slide(const Lecture& lecture, std::size_t n, Checked& all) {
    const LectureSlide& s = lecture.slides[n];
    std::string verdict = "ok";
    try {
        for (const ExpectationResult& r : played(lecture, n)) {
            ++(r.met ? all.met : all.missed);
            if (r.met) continue;
            verdict = "misses what it expects";
            all.misses += fmt::format("\n{}:{}: {} ({})", lecture.path, s.deck ? s.line : r.line, r.text, r.measured);
        }
    } catch (const Diverged& e) {
        ++all.missed, verdict = "diverges";
        all.misses += fmt::format("\n{}:{}: {}", lecture.path, s.line, e.what());
    } catch (const Refused& e) {
        ++all.refused, verdict = "cannot be shown";
        all.troubles += fmt::format("\n{}", e.what());
    }
    print_now(fmt::format("{:3}  {}: {}\n", n + 1, s.slide.title, verdict));
}

int check(const Lecture& lecture) {
    Checked all;
    for (std::size_t n = 0; n < lecture.slides.size(); ++n) check_slide(lecture, n, all);
    print(fmt::format("\n{}: {} met, {} missed; {} cannot be shown\n",
                      counted(static_cast<long long>(lecture.slides.size()), "slide"), counted(all.met, "expectation"),
                      all.missed, all.refused));
    if (all.refused) throw Refused(fmt::format("the lecture names what is not there:{}{}", all.troubles, all.misses));
    if (all.missed) throw CheckFailed("the lecture misses what it expects:" + all.misses);
    return 0;
}

// Its answer in sight, its claim measured and its map made.
void finish_slide(Lab& lab, const LectureSlide& s) {
    Session& session = lab.session();
    if (!s.claim.empty()) return lab.state().claims.book.measure_now(find_claim(s.claim));
    if (s.atlas) return lab.state().atlas.atlas.make_now(session);
    if (!session.walkthrough->revealed() && !s.slide.blocks.empty()) {
        const std::size_t here = session.slide_number();
        session.walkthrough_next();
        if (session.slide_number() != here) session.go_to_slide(here);
    }
}

int write_pictures(const Lecture& lecture, const LectureOptions& l, const WindowOptions& o) {
    const std::filesystem::path folder(l.folder);
    const Size size = size_from(o.size);
    refuse_file_ending("--out", l.folder);
    make_folder(folder);
    const auto context = open_headless(size);
    Lab lab(*context);
    lab.set_theme(o.theme.empty() ? Theme::projector : theme_from(o.theme));
    lab.set_scale(o.ui_scale == 0 ? 1 : ui_scale_from(o.ui_scale));
    lab.open_lecture(lecture);
    PdfFile pdf(lecture.title);
    std::vector<std::string> pictures;
    for (std::size_t n = 0; n < lecture.slides.size(); ++n) {
        lab.session().go_to_slide(n);
        lab.frame(0);
        if (!l.questions && lecture.slides[n].trouble.empty()) finish_slide(lab, lecture.slides[n]);
        const Image image = capture(lab, *context);
        pictures.push_back(fmt::format("slide_{:02}.png", n + 1));
        write_png(image, folder / pictures.back());
        pdf.add_page(image);
        print_now((folder / pictures.back()).string() + "\n");
    }
    write_file((folder / "lecture.pdf").string(), pdf.bytes());
    write_file((folder / "handout.html").string(), handout_html(lecture, pictures));
    print(fmt::format("{}\n{}\n", (folder / "lecture.pdf").string(), (folder / "handout.html").string()));
    return 0;
}

}  // namespace

int lecture(const LectureOptions& l, const WindowOptions& o) {
    const Lecture read = read_lecture(l.path);
    if (l.present) return window(o);
    if (!l.folder.empty()) return write_pictures(read, l, o);
    if (l.check) return check(read);
    print_outline(read);
    return 0;
}

}  // namespace pliant::viewer
