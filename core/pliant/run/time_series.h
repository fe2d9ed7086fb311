// A number over the steps of a run, in bounded memory.
#pragma once
#include <pliant/lesson/parameter.h>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// Samples of a number and, where it has one, of its exact value. A run may go on for as long as it likes: when there are `most`
// samples, groups of equally many steps keep those with their least and greatest value, exact value and error, and one that is
// undefined. The first and the last sample stay, and so do the extremes of the whole run; the latest steps stay dense.
class TimeSeries {
public:
    static constexpr std::size_t most = 16384;  // samples
    static constexpr Real undefined = std::numeric_limits<Real>::quiet_NaN();

    explicit TimeSeries(bool has_exact = false) : has_exact_(has_exact) {}

    // `at` is where the sample stands on the axis: a time in s, or the step itself. A value may be undefined. This step and later
    // ones that were added before are forgotten.
    void add(Index step, Real at, Real value, Real exact = undefined);
    void clear();
    // What lies in this part of the axis is on the screen: as far as there is room it stays dense.
    void watch(const std::optional<Interval>& part) { watched_ = part; }

    std::size_t size() const { return steps_.size(); }
    bool empty() const { return steps_.empty(); }
    bool has_exact() const { return has_exact_; }
    bool thinned() const { return span_ > 1; }
    const std::vector<Index>& steps() const { return steps_; }
    const std::vector<Real>& at() const { return at_; }
    const std::vector<Real>& values() const { return values_; }
    // Both empty where the number has no exact value. The scale is the largest |exact| so far, of all samples, kept or not.
    const std::vector<Real>& exact() const { return exact_; }
    const std::vector<Real>& scale() const { return scale_; }
    // The sample of a step, where it is kept.
    std::optional<std::size_t> find(Index step) const;

    // Memory that is held, and that may be held.
    std::size_t bytes() const;
    std::size_t cap() const { return most * (sizeof(Index) + sizeof(Real) * (has_exact_ ? 4 : 2)); }

private:
    struct Span {
        std::size_t begin, end;
    };
    void resize(std::size_t size);
    void make_room();
    void thin_out();
    Span watched() const;
    void append_kept(Span of, Index steps_per_group, std::vector<std::size_t>& kept) const;
    void append_group(Span of, std::vector<std::size_t>& kept) const;
    void keep_only(const std::vector<std::size_t>& kept);

    std::vector<Index> steps_;
    std::vector<Real> at_, values_, exact_, scale_;
    bool has_exact_;
    std::optional<Interval> watched_;
    Index span_ = 1;  // steps of a group
};

// Lines of a CSV file, each with its end: for every step that any of the series keeps the step, the time in s, 0 where there is
// no clock, and of each series the value and, where it has one, the exact value. A cell is empty where a value is undefined or
// the series does not keep the step.
std::string csv_rows(const std::vector<const TimeSeries*>& all, bool has_clock);
// A cell of it, and one of its header: "energy [J]".
std::string csv_cell(Real value);
std::string csv_column(std::string_view name, std::string_view unit);

}  // namespace pliant
