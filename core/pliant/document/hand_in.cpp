#include <pliant/document/hand_in.h>
#include <pliant/document/share.h>
#include <pliant/math/error.h>
#include <pliant/text/json_positions.h>
#include <pliant/text/sha256.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;
using Entry = HandInEntry;
constexpr std::array<std::string_view, 4> hand_in_kinds{"prediction", "measurement", "answer", "picture"};
constexpr std::array<std::string_view, 2> own_verdicts{"right", "not right"};
constexpr int hand_in_version = 1;

void put_text(Json& j, const char* key, const std::string& text) {
    if (!text.empty()) j[key] = text;
}

// The scene of a prediction has its place itself.
bool stands_somewhere(const Entry& e) { return !e.scene.empty() && e.kind != Entry::Kind::prediction; }

Json entry_json(const Entry& e) {
    Json j{{"kind", hand_in_kinds[static_cast<std::size_t>(e.kind)]}, {"lesson", e.lesson}};
    put_text(j, "slide", e.slide), put_text(j, "question", e.question);
    put_text(j, "predicted", e.predicted), put_text(j, "came", e.came);
    if (e.kind == Entry::Kind::prediction) j["right"] = e.right;
    put_text(j, "text", e.text);
    if (e.own_verdict) j["own_verdict"] = own_verdicts[*e.own_verdict ? 0 : 1];
    if (e.after_answer) j["after_answer"] = true;
    put_text(j, "scene", e.scene);
    if (stands_somewhere(e)) j["step"] = e.step, j["passes"] = e.passes, j["time"] = e.time;
    if (!e.probe.empty()) j["probe"] = e.probe, j["value"] = e.value, j["unit"] = e.unit;
    put_text(j, "slide_text", e.slide_text), put_text(j, "script", e.script), put_text(j, "left", e.left);
    if (e.guess.option) j["guess"]["option"] = *e.guess.option + 1;
    if (e.guess.number) j["guess"]["number"] = *e.guess.number;
    if (!e.guess.sketch.empty()) j["guess"]["sketch"] = e.guess.sketch;
    put_text(j, "png", e.png);
    return j;
}

Json content_json(const HandIn& h) {
    Json j{{"pliant_handin", hand_in_version}, {"name", h.name}, {"entries", Json::array()}};
    for (const Entry& e : h.entries) j["entries"].push_back(entry_json(e));
    return j;
}

std::string dumped(const Json& j, int indent) { return j.dump(indent, ' ', false, Json::error_handler_t::replace); }

// Blanks and line ends of the file do not count.
std::string checksum_of(Json j) {
    j.erase("checksum");
    return "sha256:" + sha256(dumped(j, -1));
}

class HandInReader {
public:
    HandInReader(std::string_view text, std::string_view path) : path_(path), json_(parse_json(text, path)) {}

    HandInRead read() {
        const Json& root = json_.value;
        if (!root.is_object() || !root.contains("pliant_handin"))
            refuse("", "this is no hand-in: it begins with {\"pliant_handin\": 1, \"name\": ..., \"entries\": [...]}");
        if (root["pliant_handin"] != hand_in_version)
            refuse("/pliant_handin", fmt::format("this version of Pliant reads hand-ins of version {}", hand_in_version));
        HandInRead result;
        result.hand_in.name = text_at(root, "", "name", true);
        if (!root.contains("entries") || !root["entries"].is_array()) refuse("", "\"entries\" is missing: a list");
        for (std::size_t k = 0; k < root["entries"].size(); ++k)
            result.hand_in.entries.push_back(entry(root["entries"][k], fmt::format("/entries/{}", k)));
        result.unchanged = text_at(root, "", "checksum", false) == checksum_of(root);
        return result;
    }

private:
    [[noreturn]] void refuse(const std::string& pointer, const std::string& what) const {
        const TextPlace p = json_.at(pointer);
        throw Refused(fmt::format("{}:{}:{}: {}", path_, p.line, p.column, what));
    }
    std::string text_at(const Json& j, const std::string& pointer, const char* key, bool needed) const {
        if (!j.contains(key)) {
            if (needed) refuse(pointer, fmt::format("\"{}\" is missing", key));
            return "";
        }
        if (!j[key].is_string()) refuse(pointer + "/" + key, fmt::format("\"{}\" has to be a text", key));
        return j[key].get<std::string>();
    }
    Real number_at(const Json& j, const std::string& pointer, const char* key) const {
        if (!j.contains(key) || !j[key].is_number()) refuse(pointer, fmt::format("\"{}\" has to be a number", key));
        return j[key].get<Real>();
    }
    Index whole_at(const Json& j, const std::string& pointer, const char* key) const {
        const Real value = number_at(j, pointer, key);
        if (!(value >= 0) || value != std::floor(value) || value > 1e9)
            refuse(pointer + "/" + key, fmt::format("\"{}\" has to be a whole number from 0 on", key));
        return static_cast<Index>(value);
    }

    Guess guess(const Json& j, const std::string& at) const {
        if (!j.is_object()) refuse(at, "\"guess\" is an object");
        Guess g;
        if (j.contains("option")) {
            const Index option = whole_at(j, at, "option");
            if (option == 0) refuse(at + "/option", "\"option\" counts from 1");
            g.option = static_cast<std::size_t>(option - 1);
        }
        if (j.contains("number")) g.number = number_at(j, at, "number");
        if (!j.contains("sketch")) return g;
        const Json& sketch = j["sketch"];
        const auto is_number = [](const Json& value) { return value.is_number(); };
        if (!sketch.is_array() || sketch.size() != sketch_points || !std::ranges::all_of(sketch, is_number))
            refuse(at + "/sketch", fmt::format("\"sketch\" has to be {} numbers", sketch_points));
        return g.sketch = sketch.get<Sketch>(), g;
    }

    Entry entry(const Json& j, const std::string& at) const {
        if (!j.is_object()) refuse(at, "an entry is an object");
        Entry e;
        const std::string kind = text_at(j, at, "kind", true);
        const auto known = std::ranges::find(hand_in_kinds, kind);
        if (known == hand_in_kinds.end())
            refuse(at + "/kind", fmt::format("'{}' is no kind of entry: prediction, measurement, answer or picture", kind));
        e.kind = static_cast<Entry::Kind>(known - hand_in_kinds.begin());
        e.lesson = text_at(j, at, "lesson", true);
        e.slide = text_at(j, at, "slide", false), e.question = text_at(j, at, "question", false);
        e.predicted = text_at(j, at, "predicted", false), e.came = text_at(j, at, "came", false);
        e.text = text_at(j, at, "text", false);
        if (e.kind == Entry::Kind::prediction) {
            if (!j.contains("right") || !j["right"].is_boolean()) refuse(at, "\"right\" has to be true or false");
            e.right = j["right"].get<bool>();
            e.slide_text = text_at(j, at, "slide_text", false);
            e.script = text_at(j, at, "script", false), e.left = text_at(j, at, "left", false);
            if (j.contains("guess")) e.guess = guess(j["guess"], at + "/guess");
        }
        if (const std::string own = text_at(j, at, "own_verdict", false); !own.empty()) {
            if (std::ranges::find(own_verdicts, own) == own_verdicts.end())
                refuse(at + "/own_verdict", fmt::format("'{}' is no verdict: right, or not right", own));
            e.own_verdict = own == own_verdicts[0];
        }
        if (j.contains("after_answer")) {
            if (!j["after_answer"].is_boolean()) refuse(at + "/after_answer", "\"after_answer\" has to be true or false");
            e.after_answer = j["after_answer"].get<bool>();
        }
        const bool measured = e.kind == Entry::Kind::measurement, picture = e.kind == Entry::Kind::picture;
        e.scene = text_at(j, at, "scene", measured || picture);
        if (stands_somewhere(e))
            e.step = whole_at(j, at, "step"), e.passes = whole_at(j, at, "passes"), e.time = number_at(j, at, "time");
        if (measured) {
            e.probe = text_at(j, at, "probe", true), e.unit = text_at(j, at, "unit", true);
            e.value = number_at(j, at, "value");
        }
        if (picture) e.png = text_at(j, at, "png", true);
        return e;
    }

    std::string path_;
    PlacedJson json_;
};

}  // namespace

std::string hand_in_text(const HandIn& h) {
    Json j = content_json(h);
    j["checksum"] = checksum_of(j);
    return dumped(j, 1) + "\n";
}

std::string hand_in_file_name(const HandIn& h, std::string_view lesson) {
    std::set<std::string_view> lessons;
    for (const Entry& e : h.entries) lessons.insert(e.lesson);
    const std::string_view of = lessons.empty() ? lesson : *lessons.begin();
    const std::string_view work = lessons.size() > 1 ? "work" : of.substr(of.find('/') + 1);
    std::string name;
    for (const char c : h.name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool takes = byte >= 0x80 || std::isalnum(byte) || c == '-';
        if (takes)
            name += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    if (!name.empty() && name.back() != '_') name += '_';
    return fmt::format("{}{}{}", name, work, hand_in_ending);
}

HandInRead read_hand_in(std::string_view text, std::string_view path) { return HandInReader(text, path).read(); }

HandInEntry measurement_of(const Runner& runner, std::string_view probe) {
    const Probe& p = runner.lesson().probe(probe);
    HandInEntry e{.kind = Entry::Kind::measurement, .lesson = std::string(runner.info().id)};
    e.scene = share_text(scene_of(runner));
    e.step = runner.place().step, e.passes = runner.place().passes, e.time = runner.time();
    e.probe = p.name, e.unit = p.unit, e.value = runner.value(probe);
    return e;
}

}  // namespace pliant
