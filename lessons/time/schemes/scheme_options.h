// The time integrators as options of a choice.
#pragma once
#include <pliant/lesson/parameter.h>
#include <pliant/time/scheme.h>

#include <vector>

namespace pliant {

// The first `count` schemes, in the order of the enumeration; 3 are those of the lecture.
inline std::vector<Option> scheme_options(std::size_t count = schemes().size()) {
    std::vector<Option> options;
    for (const SchemeInfo& info : schemes())
        if (options.size() < count) options.push_back({info.key, info.name});
    return options;
}

}  // namespace pliant
