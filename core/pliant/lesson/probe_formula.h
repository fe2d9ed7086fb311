// A probe that is what its formula gives.
#pragma once
#include <pliant/formula/formula.h>
#include <pliant/lesson/explanation.h>

#include <memory>
#include <optional>
#include <vector>

namespace pliant {

class Lesson;
struct Field;
struct Probe;

// The formula is read once, when it is first asked for, and evaluated on slots that stay where they are: numbers where they live,
// in parameters, fields and other probes, or what Input::live gives.
class ProbeFormula {
public:
    // The lesson must outlive it.
    ProbeFormula(const Lesson& lesson, FormulaText text, std::vector<Input> inputs);

    // Empty where an input is not defined, or where the formula gives no finite number. Throws BadFormula, with its place in the
    // sources.
    std::optional<Real> value();
    // The same for whoever asks why, who looks the numbers up.
    Explanation explanation() const;

private:
    struct Slot {
        const Parameter* parameter = nullptr;
        const Field* field = nullptr;
        const Probe* probe = nullptr;
        std::unique_ptr<ProbeFormula> part{};
    };
    void resolve();
    FormulaSymbol symbol_of(const Input& in, Slot& slot) const;
    bool fill(const Input& in, const Slot& slot, std::size_t k);

    const Lesson& lesson_;
    FormulaText text_;
    std::vector<Input> inputs_;
    std::optional<Formula> formula_{};
    std::vector<Slot> slots_{};
    std::vector<Real> numbers_{};
    std::vector<FormulaNumbers> slots_of_formula_{};
};

}  // namespace pliant
