// How one formula is laid out at one size. Within this folder; others call set_formula (math_box.h).
#pragma once
#include "typeset/math_box.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace pliant::viewer {

class Setter {
public:
    Setter(const MathMetrics& metrics, float size, float whole) : metrics_(metrics), size_(size), whole_(whole) {}

    // In the face of the words: of a sentence that has numbers but no symbols.
    void set_prose() { prose_ = true; }

    MathBox lines(const Notation& row, float width) const;

private:
    using Kind = Notation::Kind;

    // Lengths in heights of a line of type, after the look of the face.
    static constexpr float script_size = 0.72f, smallest_script = 0.55f, fraction_size = 0.92f;
    static constexpr float around_sign = 0.20f, around_relation = 0.25f, after_comma = 0.22f, between_formulas = 1.1f,
                           beside_words = 0.24f, between_factors = 0.13f, after_name = 0.14f;
    static constexpr float fraction_gap = 0.10f, rule = 0.055f, line_gap = 0.30f, indent = 1.2f;

    Setter smaller(float factor) const {
        Setter inner(metrics_, std::max(size_ * factor, whole_ * smallest_script), whole_);
        inner.prose_ = prose_;
        return inner;
    }
    bool is_script() const { return size_ < 0.8f * whole_; }
    float thickness() const { return std::max(1.f, std::round(size_ * rule)); }
    // Of the line on which fractions and signs are centred.
    float axis() const {
        const LetterBounds minus = metrics_.bounds(U'−', MathFace::signs, size_);
        return (minus.top + minus.bottom) / 2;
    }

    MathBox letters(std::string_view text, bool leans = false, MathFace face = MathFace::signs) const;
    MathBox stretched(char32_t letter, float top, float bottom) const;
    MathBox piece(const Notation& n) const;
    MathBox row(const Notation& n) const;
    MathBox fraction(const Notation& n) const;
    MathBox root(const Notation& n) const;
    MathBox scripts(const Notation& n) const;
    MathBox limits(const Notation& n) const;
    MathBox accent(const Notation& n) const;
    MathBox fence(const Notation& n) const;
    float lean(const MathBox& box) const;
    MathBox grid(const Notation& n) const;
    float gap_between(const Notation* before, const Notation& next) const;

    const MathMetrics& metrics_;
    float size_, whole_;
    bool prose_ = false;
};

// The formulas of a line that gaps part.
std::vector<Notation> formulas_of(const Notation& row);

}  // namespace pliant::viewer
