// Why the present scene does not use a parameter, in the words of the lab.
#pragma once
#include <pliant/run/runner.h>

#include <map>
#include <string>
#include <string_view>

namespace pliant::viewer {

class UsageReasons {
public:
    // "Used when path is “any F”."; what was found is kept until a parameter changes.
    const std::string& reason(const Runner& runner, const Parameter& parameter);
    // What was found last of the parameter with this key; null for nothing.
    const std::string* known(std::string_view key) const;

private:
    std::string_view lesson_;
    Runner::Assignments values_;
    std::map<std::string_view, std::string> reasons_;  // by key
};

}  // namespace pliant::viewer
