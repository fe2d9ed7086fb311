#include <pliant/run/time_series.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pliant {

void TimeSeries::add(Index step, Real at, Real value, Real exact) {
    resize(static_cast<std::size_t>(std::ranges::lower_bound(steps_, step) - steps_.begin()));
    if (size() == most) thin_out();
    make_room();
    steps_.push_back(step);
    at_.push_back(at);
    values_.push_back(value);
    if (!has_exact_) return;
    const Real before = scale_.empty() ? 0 : scale_.back();
    exact_.push_back(exact);
    scale_.push_back(std::isfinite(exact) ? std::max(before, std::abs(exact)) : before);
}

void TimeSeries::clear() {
    resize(0);
    span_ = 1;
}

std::optional<std::size_t> TimeSeries::find(Index step) const {
    const auto found = std::ranges::lower_bound(steps_, step);
    if (found == steps_.end() || *found != step) return std::nullopt;
    return static_cast<std::size_t>(found - steps_.begin());
}

std::size_t TimeSeries::bytes() const {
    return steps_.capacity() * sizeof(Index) +
           (at_.capacity() + values_.capacity() + exact_.capacity() + scale_.capacity()) * sizeof(Real);
}

void TimeSeries::resize(std::size_t size) {
    steps_.resize(size);
    for (std::vector<Real>* column : {&at_, &values_}) column->resize(size);
    if (has_exact_) exact_.resize(size), scale_.resize(size);
}

// No column ever holds more than `most`, however its vector likes to grow.
void TimeSeries::make_room() {
    if (size() < steps_.capacity()) return;
    const std::size_t wanted = std::clamp<std::size_t>(2 * size(), 64, most);
    steps_.reserve(wanted);
    for (std::vector<Real>* column : {&at_, &values_}) column->reserve(wanted);
    if (has_exact_) exact_.reserve(wanted), scale_.reserve(wanted);
}

// Half as many samples; of those on the screen a quarter of all may stay.
void TimeSeries::thin_out() {
    const Span seen = watched();
    std::vector<std::size_t> kept;
    const auto thin = [&](Index outside, Index inside) {
        kept.clear();
        append_kept({0, seen.begin}, outside, kept);
        const std::size_t first = kept.size();
        append_kept(seen, inside, kept);
        const std::size_t of_seen = kept.size() - first;
        append_kept({seen.end, size()}, outside, kept);
        return of_seen;
    };
    Index inside = 1;
    while (thin(std::max<Index>(span_, 2), inside) > most / 4) inside *= 2;
    for (span_ = std::max<Index>(span_, 2); thin(span_, inside), kept.size() > most / 2;) span_ *= 2;
    keep_only(kept);
}

TimeSeries::Span TimeSeries::watched() const {
    if (!watched_) return {0, 0};
    const auto begin = std::ranges::lower_bound(at_, watched_->min), end = std::upper_bound(begin, at_.end(), watched_->max);
    return {static_cast<std::size_t>(begin - at_.begin()), static_cast<std::size_t>(end - at_.begin())};
}

// Of each group of so many steps what it keeps, in order.
void TimeSeries::append_kept(Span of, Index steps_per_group, std::vector<std::size_t>& kept) const {
    for (std::size_t begin = of.begin; begin < of.end;) {
        const Index group = steps_[begin] / steps_per_group;
        std::size_t end = begin + 1;
        while (end < of.end && steps_[end] / steps_per_group == group) ++end;
        append_group({begin, end}, kept);
        begin = end;
    }
}

void TimeSeries::append_group(Span of, std::vector<std::size_t>& kept) const {
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::size_t low = none, high = none, gap = none, low_exact = none, high_exact = none, worst = none;
    const auto note = [](std::size_t& best, std::size_t i, Real x, Real than, bool greater) {
        if (best == none || (greater ? x > than : x < than)) best = i;
    };
    const auto old = [](const std::vector<Real>& column, std::size_t i) { return i == none ? 0 : column[i]; };
    const auto error = [this](std::size_t i) { return i == none ? 0 : std::abs(values_[i] - exact_[i]); };
    for (std::size_t i = of.begin; i < of.end; ++i) {
        const bool defined = std::isfinite(values_[i]), has_exact = has_exact_ && std::isfinite(exact_[i]);
        if (!defined && gap == none) gap = i;
        if (defined) note(low, i, values_[i], old(values_, low), false), note(high, i, values_[i], old(values_, high), true);
        if (!has_exact) continue;
        note(low_exact, i, exact_[i], old(exact_, low_exact), false);
        note(high_exact, i, exact_[i], old(exact_, high_exact), true);
        if (defined) note(worst, i, error(i), error(worst), true);
    }
    std::array<std::size_t, 8> wanted{low, high, gap, low_exact, high_exact, worst, none, none};
    // The ends of the whole.
    if (of.begin == 0) wanted[6] = 0;
    if (of.end == size()) wanted[7] = size() - 1;
    std::ranges::sort(wanted);
    for (std::size_t k = 0; k < wanted.size() && wanted[k] != none; ++k)
        if (k == 0 || wanted[k] != wanted[k - 1]) kept.push_back(wanted[k]);
}

void TimeSeries::keep_only(const std::vector<std::size_t>& kept) {
    const auto pick = [&kept](auto& column) {
        for (std::size_t k = 0; k < kept.size(); ++k) column[k] = column[kept[k]];
        column.resize(kept.size());
    };
    pick(steps_);
    for (std::vector<Real>* column : {&at_, &values_}) pick(*column);
    if (has_exact_) pick(exact_), pick(scale_);
}

std::string csv_cell(Real value) { return std::isfinite(value) ? format_exact(value) : ""; }

std::string csv_column(std::string_view name, std::string_view unit) {
    return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

std::string csv_rows(const std::vector<const TimeSeries*>& all, bool has_clock) {
    std::vector<std::pair<Index, Real>> moments;
    for (const TimeSeries* s : all)
        for (std::size_t i = 0; i < s->size(); ++i) moments.emplace_back(s->steps()[i], has_clock ? s->at()[i] : 0);
    std::ranges::sort(moments);
    moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
    std::string text;
    for (const auto& [step, time] : moments) {
        text += fmt::format("{},{}", step, format_exact(time));
        for (const TimeSeries* s : all) {
            const auto i = s->find(step);
            text += "," + (i ? csv_cell(s->values()[*i]) : "");
            if (s->has_exact()) text += "," + (i ? csv_cell(s->exact()[*i]) : "");
        }
        text += "\n";
    }
    return text;
}

}  // namespace pliant
