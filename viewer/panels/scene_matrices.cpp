#include "panels/scene_matrices.h"

#include "panels/companion_panel.h"
#include "panels/typeset_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace pliant::viewer {
namespace {

// A matrix as words, and the space that they take.
struct MatrixBlock {
    std::vector<std::string> entries;
    std::string before, behind;  // "F =", "10⁶ Pa"
    int rows = 0, columns = 0;
    Ink ink = Ink::text;
    float column_width = 0, before_width = 0;
    ImVec2 size{};
};

constexpr const char* superscripts[]{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

std::string raised(int exponent) {
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char digit : fmt::format("{}", std::abs(exponent))) text += superscripts[digit - '0'];
    return text;
}

// A multiple of three, so that the largest number has one to three digits before its point; 0 for numbers that read well as they
// are.
int common_exponent(const MatrixMark& m) {
    Real largest = 0;
    for (const Real x : m.entries) largest = std::max(largest, std::abs(x));
    if (largest == 0 || (largest >= 1e-2 && largest < 1e3)) return 0;
    return 3 * static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-12));
}

std::string entry_text(Real x, int decimals) {
    if (!std::isfinite(x)) return "–";
    const std::string text = fmt::format("{:.{}f}", x, decimals);
    // No minus sign on what is 0 to the digits shown; a plain 0 shows where nothing is.
    if (std::strtod(text.c_str(), nullptr) == 0) return x == 0 ? "0" : text.substr(text.front() == '-');
    return text.front() == '-' ? "−" + text.substr(1) : text;
}

MatrixBlock measured(PanelContext& lab, const MatrixMark& m) {
    const int exponent = common_exponent(m);
    MatrixBlock b{
        .entries = {}, .before = as_formula(m.name + " ="), .behind = m.unit, .rows = m.rows, .columns = m.columns, .ink = m.ink};
    if (exponent) b.behind = fmt::format("10{}{}{}", raised(exponent), m.unit.empty() ? "" : " ", m.unit);
    Real largest = 0;
    for (const Real x : m.entries) largest = std::max(largest, std::abs(x) * std::pow(10.0, -exponent));
    const int decimals = largest >= 100 ? 1 : largest >= 10 ? 2 : 3;
    for (const Real x : m.entries) {
        b.entries.push_back(as_formula(entry_text(x * std::pow(10.0, -exponent), decimals)));
        b.column_width = std::max(b.column_width, sentence_width(lab, b.entries.back()));
    }
    b.before_width = sentence_width(lab, b.before);
    const auto columns = static_cast<float>(m.columns);
    const float behind = sentence_width(lab, b.behind);
    b.size = {b.before_width + columns * (b.column_width + lab.px(9)) + behind + lab.px(20),
              static_cast<float>(m.rows) * ImGui::GetTextLineHeight() + lab.px(6)};
    return b;
}

void draw_block(PanelContext& lab, const MatrixBlock& b, ImVec2 at) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const unsigned ink = lab.ink(b.ink);
    const float line = ImGui::GetTextLineHeight(), pad = lab.px(4), tick = lab.px(4);
    draw->AddRectFilled({at.x - pad, at.y - pad}, {at.x + b.size.x + pad, at.y + b.size.y + pad},
                        ImGui::GetColorU32(ImGuiCol_WindowBg, 0.82f), lab.px(4));
    const float middle = at.y + (b.size.y - line) / 2;
    draw_sentence(lab, {at.x, at.y + (b.size.y - sentence_box(lab, b.before).height()) / 2}, ink, b.before);
    const float left = at.x + b.before_width + lab.px(5), cell = b.column_width + lab.px(9);
    const float right = left + static_cast<float>(b.columns) * cell + lab.px(5);
    for (const auto& [x, inward] : {std::pair{left, tick}, {right, -tick}}) {
        draw->AddLine({x, at.y}, {x, at.y + b.size.y}, ink, std::max(1.f, lab.px(1.5f)));
        draw->AddLine({x, at.y}, {x + inward, at.y}, ink, std::max(1.f, lab.px(1.5f)));
        draw->AddLine({x, at.y + b.size.y}, {x + inward, at.y + b.size.y}, ink, std::max(1.f, lab.px(1.5f)));
    }
    for (std::size_t k = 0; k < b.entries.size(); ++k) {
        const auto row = static_cast<float>(static_cast<int>(k) / b.columns),
                   column = static_cast<float>(static_cast<int>(k) % b.columns);
        const float x = left + (column + 1) * cell - sentence_width(lab, b.entries[k]);
        draw_sentence(lab, {x, at.y + lab.px(3) + row * line}, ink, b.entries[k]);
    }
    draw_sentence(lab, {right + lab.px(5), middle}, ink, b.behind);
}

struct Placed {
    MatrixBlock block;
    ImVec2 at;
};

// As many as fit into the lower half of the place: the upper one is left to the picture.
std::vector<Placed> placed(PanelContext& lab, const std::vector<MatrixMark>& matrices, const Rectangle& place) {
    const float gap = lab.px(16), left = place.x + lab.px(14);
    float x = left, bottom = place.y + place.height - lab.px(14), tallest = 0;
    std::vector<Placed> blocks;
    for (const MatrixMark& m : matrices) {
        MatrixBlock b = measured(lab, m);
        if (x > left && x + b.size.x > place.x + place.width - lab.px(14)) x = left, bottom -= tallest + gap, tallest = 0;
        if (bottom - b.size.y < place.y + place.height / 2 || b.size.x > place.width) break;
        const ImVec2 at{x, bottom - b.size.y};
        x += b.size.x + gap;
        tallest = std::max(tallest, b.size.y);
        blocks.push_back({std::move(b), at});
    }
    return blocks;
}

}  // namespace

void draw_matrices(PanelContext& lab, const std::vector<MatrixMark>& matrices, const Rectangle& place) {
    if (matrices.empty()) return;
    // What a lecture hall reads is as large as leaves the picture most of the room.
    const bool large = lab.layout != Layout::lab;
    for (ImFont* font : {lab.fonts.medium, lab.fonts.normal, lab.fonts.small}) {
        if (!large && font != lab.fonts.small) continue;
        ImGui::PushFont(font);
        const std::vector<Placed> blocks = placed(lab, matrices, place);
        const bool last = font == lab.fonts.small;
        const bool fit = blocks.size() == matrices.size() && blocks.back().at.y > place.y + 0.6f * place.height;
        if (fit || last)
            for (const Placed& p : blocks) {
                draw_block(lab, p.block, p.at);
                lab.note_fillable({p.at.x, p.at.y, p.block.size.x, p.block.size.y}, {Filled::matrix, ""});
            }
        ImGui::PopFont();
        if (fit) return;
    }
}

namespace {

struct RowOfMatrices {
    std::vector<MatrixBlock> blocks;
    float width = 0, height = 0;
};

// As many beside each other as there is room for.
std::vector<RowOfMatrices> rows_of_matrices(PanelContext& lab, const std::vector<MatrixMark>& matrices, float width, float gap) {
    std::vector<RowOfMatrices> rows;
    for (const MatrixMark& m : matrices) {
        MatrixBlock b = measured(lab, m);
        if (rows.empty() || rows.back().width + gap + b.size.x > width) rows.emplace_back().width = -gap;
        RowOfMatrices& row = rows.back();
        row.width += gap + b.size.x;
        row.height = std::max(row.height, b.size.y);
        row.blocks.push_back(std::move(b));
    }
    return rows;
}

bool draw_rows(PanelContext& lab, const std::vector<RowOfMatrices>& rows, const Rectangle& place, float gap, bool whatever) {
    float height = -gap, width = 0;
    for (const RowOfMatrices& row : rows) height += row.height + gap, width = std::max(width, row.width);
    if (!whatever && (height > place.height || width > place.width)) return false;
    float y = place.y + std::max(0.f, (place.height - height) / 2);
    for (const RowOfMatrices& row : rows) {
        float x = place.x + std::max(0.f, (place.width - row.width) / 2);
        for (const MatrixBlock& b : row.blocks) draw_block(lab, b, {x, y + (row.height - b.size.y) / 2}), x += b.size.x + gap;
        y += row.height + gap;
    }
    return true;
}

// With a heading where there are two runs.
void fill_with(PanelContext& lab, const std::vector<MatrixMark>& matrices, const std::string& heading, Rectangle place) {
    if (!heading.empty()) {
        ImGui::PushFont(lab.fonts.medium);
        const float line = 1.6f * ImGui::GetTextLineHeight();
        draw_sentence(lab, {place.x, place.y}, lab.ink(Ink::accent), heading);
        place.y += line, place.height -= line;
        ImGui::PopFont();
    }
    for (ImFont* font :
         {lab.fonts.huge, lab.fonts.larger, lab.fonts.large, lab.fonts.medium, lab.fonts.normal, lab.fonts.small}) {
        ImGui::PushFont(font);
        const float gap = 1.2f * font->FontSize;
        const bool drawn = draw_rows(lab, rows_of_matrices(lab, matrices, place.width, gap), place, gap, font == lab.fonts.small);
        ImGui::PopFont();
        if (drawn) return;
    }
}

}  // namespace

void draw_filled_matrices(PanelContext& lab) {
    Session& s = lab.session;
    const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const float pad = lab.px(20);
    const Rectangle place{at.x + pad, at.y + pad, room.x - 2 * pad, room.y - 2 * pad};
    const KeptPicture a = s.picture(), b = s.companion() && !s.shows_difference() ? s.picture_beside() : nullptr;
    if (a->scene.matrices.empty()) return ImGui::TextDisabled("The picture has no matrices now.");
    if (!b) return fill_with(lab, a->scene.matrices, "", place);
    const float half = (place.width - pad) / 2;
    fill_with(lab, a->scene.matrices, run_name(s, false), {place.x, place.y, half, place.height});
    fill_with(lab, b->scene.matrices, run_name(s, true), {place.x + half + pad, place.y, half, place.height});
}

}  // namespace pliant::viewer
