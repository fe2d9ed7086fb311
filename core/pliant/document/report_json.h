// What the reports share.
#pragma once
#include <pliant/document/unused.h>
#include <pliant/lesson/parameter.h>

#include <nlohmann/json.hpp>

namespace pliant {

// A choice as its key, a switch as true or false, a file as its path.
inline nlohmann::ordered_json value_json(const Parameter& p, Real value) {
    switch (p.info.kind) {
        case Kind::choice:
        case Kind::file:
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

// What each of them needs, by key.
inline nlohmann::ordered_json unused_json(const std::vector<UnusedSetting>& unused) {
    auto j = nlohmann::ordered_json::object();
    for (const UnusedSetting& u : unused) j[u.key] = u.needs;
    return j;
}

}  // namespace pliant
