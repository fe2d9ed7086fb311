// The page that goes with a lecture.
#include <pliant/document/share.h>
#include <pliant/lecture/lecture.h>
#include <pliant/study/claims.h>

#include <fmt/format.h>

namespace pliant {
namespace {

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text)
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
}

std::string paragraph(std::string_view kind, const std::string& text) {
    return fmt::format("<p class=\"{}\">{}</p>\n", kind, escaped(text));
}

std::string words(const LectureSlide& s) {
    std::string html;
    for (const Block& b : s.slide.blocks) {
        if (b.kind == BlockKind::text) html += paragraph("text", b.paragraph());
        if (b.kind == BlockKind::ask) html += paragraph("ask", b.paragraph());
        if (b.kind == BlockKind::answer) html += paragraph("answer", b.paragraph());
        if (b.kind == BlockKind::formula)
            for (const std::string& line : b.lines) html += paragraph("formula", line);
    }
    if (!s.claim.empty()) html += paragraph("ask", find_claim(s.claim).statement);
    return html;
}

// What cannot be shared is said in its place.
std::string share(const Lecture& lecture, std::size_t n) {
    try {
        const auto scene = scene_to_share(lecture, n);
        if (!scene) return "";
        return fmt::format("<p class=\"share\">Open it in Pliant (copy this line, then Ctrl Shift V):<br><code>{}</code></p>\n",
                           share_text(*scene));
    } catch (const Error& e) {
        return paragraph("share", fmt::format("The scene cannot be shared: {}", e.what()));
    }
}

constexpr std::string_view style = R"(<style>
body{font:16px/1.5 "DejaVu Sans",sans-serif;max-width:46em;margin:2em auto;padding:0 1em}
img{width:100%;border:1px solid #999}section{break-inside:avoid;margin-bottom:3em}
.formula{font-family:"DejaVu Serif",serif;font-style:italic;margin-left:2em}.ask{font-weight:bold}
.share,.trouble{font-size:80%}code{overflow-wrap:anywhere}
</style>
)";

}  // namespace

std::optional<SceneFile> scene_to_share(const Lecture& lecture, std::size_t n) {
    const LectureSlide& s = lecture.slides.at(n);
    if (!s.trouble.empty() || s.lesson().empty()) return std::nullopt;
    if (s.scene) return s.scene;
    if (!s.claim.empty()) {
        const Claim& claim = find_claim(s.claim);
        return SceneFile{.lesson = claim.lesson, .parameters = claim.scene};
    }
    const LessonEntry& entry = find_lesson(s.deck->lesson);
    Runner runner(entry);
    WalkthroughPlayer player(runner, walkthrough_of(entry));
    player.go_to_slide(s.deck->number);
    return scene_of(runner);
}

std::string handout_html(const Lecture& lecture, const std::vector<std::string>& pictures) {
    std::string html =
        fmt::format("<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>{0}</title>\n{1}<h1>{0}</h1>\n",
                    escaped(lecture.title), style);
    for (std::size_t n = 0; n < lecture.slides.size(); ++n) {
        const LectureSlide& s = lecture.slides[n];
        html += fmt::format("<section><h2>{}. {}</h2>\n", n + 1, escaped(s.slide.title));
        if (n < pictures.size() && !pictures[n].empty())
            html += fmt::format("<img src=\"{}\" alt=\"{}\">\n", escaped(pictures[n]), escaped(s.slide.title));
        html += s.trouble.empty() ? words(s) + share(lecture, n) : paragraph("trouble", s.trouble);
        html += "</section>\n";
    }
    return html + "</html>\n";
}

}  // namespace pliant
