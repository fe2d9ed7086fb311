// Parameters of a session's lesson, by key.
#pragma once
#include "session/session.h"

namespace pliant::test {

inline const Parameter& parameter(const viewer::Session& session, std::string_view key) {
    return session.lesson().parameter(key);
}
// What the sliders stand at.
inline Real wanted(const viewer::Session& session, std::string_view key) {
    return session.runner().wanted(parameter(session, key));
}

}  // namespace pliant::test
