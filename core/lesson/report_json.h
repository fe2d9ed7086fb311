// What the reports share.
#pragma once
#include <pliant/lesson/parameter.h>

#include <nlohmann/json.hpp>

namespace pliant {

// A choice as its key, a switch as true or false.
inline nlohmann::ordered_json value_json(const Parameter& p, Real value) {
    switch (p.info.kind) {
        case Kind::choice:
            return p.text(value);
        case Kind::toggle:
            return value != 0;
        case Kind::whole:
            return static_cast<long long>(value);
        case Kind::number:
            break;
    }
    return value;
}

}  // namespace pliant
