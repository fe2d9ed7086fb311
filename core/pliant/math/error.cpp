#include <pliant/math/error.h>

#include <fmt/format.h>

namespace pliant {
namespace {

std::string sentence(const Failure& f) {
    std::string text = "diverged";
    if (f.step >= 0) text += fmt::format(" in step {} (t = {:.6g} s)", f.step, f.time);
    if (!f.stage.empty()) text += fmt::format(", stage '{}'", f.stage);
    if (!f.field.empty()) text += fmt::format(", field '{}'", f.field);
    if (f.index >= 0) text += fmt::format(", index {}", f.index);
    if (!f.what.empty()) text += ": " + f.what;
    if (!f.limit.empty()) text += ". " + f.limit;
    return text;
}

}  // namespace

Refused::Refused(std::string_view name, Real value, std::string_view unit, std::string_view accepted)
    : Refused(fmt::format("{} = {}{}{} is not accepted: give {}", name, value, unit.empty() ? "" : " ", unit, accepted)) {}

Diverged::Diverged(Failure f) : Error(ExitCode::diverged, sentence(f)), failure(std::move(f)) {}

}  // namespace pliant
