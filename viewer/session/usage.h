// Why the present scene does not use a parameter, in the words of the lab.
#pragma once
#include <pliant/run/runner.h>

#include <map>
#include <string>
#include <string_view>

namespace pliant::viewer {

class UsageReasons {
public:
    // "Used with path=free."; what was found is kept until a parameter changes.
    const std::string& reason(const Runner& runner, const Parameter& parameter);

private:
    std::string_view lesson_;
    Runner::Assignments values_;
    std::map<std::string_view, std::string> reasons_;  // by key
};

}  // namespace pliant::viewer
