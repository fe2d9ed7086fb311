// A slide of a lecture as its file says it, before anything is looked up: what JSON and Markdown have in common.
#pragma once
#include <pliant/lecture/lecture.h>
#include <pliant/text/json_positions.h>

#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// A key of a slide with what stands behind it: a value, or one for each element, "key=value" for each member of an object.
struct SlideFact {
    std::string key;
    std::vector<std::string> values;
    std::string place;  // "path:line" or "path:line:column"
    // Of JSON: the values are then one, the text of the object behind as many lines and blanks as stand before it in the file.
    bool is_object = false;
};

struct SlideFacts {
    Slide slide;
    std::vector<SlideFact> facts;
    std::string path, place;
    std::string trouble{};  // what was already found to be wrong
};

// The keys of facts, in the order in which they are told.
const std::vector<std::string>& slide_fact_keys();

// One slide, or several of a deck. What is wrong becomes their trouble. `folder`: of the lecture, for paths.
std::vector<LectureSlide> lecture_slides(const SlideFacts& said, const std::string& folder);

}  // namespace pliant
