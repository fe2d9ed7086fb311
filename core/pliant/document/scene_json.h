// The JSON of a scene: what is read from it, with its place where it is refused.
#pragma once
#include <pliant/document/scene_file.h>
#include <pliant/text/json_positions.h>
#include <pliant/text/suggest.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

using SceneJson = nlohmann::ordered_json;

// Throws Refused as "path:line:column: ..." for all that does not belong.
class SceneReader {
public:
    SceneReader(std::string_view text, std::string_view path) : path_(path), json_(parse_json(text, path)) {}
    SceneFile read();

private:
    [[noreturn]] void refuse(const std::string& pointer, const std::string& what) const;
    // Adds the place to an error that the lesson raises.
    template <class Check>
    void checked(const std::string& pointer, Check check) const {
        try {
            check();
        } catch (const Refused& e) {
            refuse(pointer, e.what());
        }
    }
    void check_version(const SceneJson& root) const;
    // With first: those of version 1; the others need version 2.
    void known_keys(const SceneJson& object, const std::string& pointer, const std::vector<std::string>& known,
                    std::size_t first = 0) const;

    // --- single values; a value that is missing leaves what is there ---
    std::string text_at(const SceneJson& object, const std::string& key, const std::string& pointer) const;
    Real number_at(const SceneJson& v, const std::string& pointer, const std::string& name) const;
    Index whole_at(const SceneJson& v, const std::string& pointer, const std::string& name, Index least, Index most) const;
    void take_flag(const SceneJson& object, const std::string& pointer, const char* key, bool& flag) const;
    void take_whole(const SceneJson& object, const std::string& pointer, const char* key, Index least, Index most,
                    Index& number) const;
    void take_name(const SceneJson& object, const std::string& pointer, const char* key, std::span<const std::string_view> known,
                   std::string& name) const;
    std::optional<Interval> range_at(const SceneJson& object, const std::string& pointer, const char* key) const;
    std::vector<std::string> texts_at(const SceneJson& object, const std::string& pointer, const char* key) const;
    Vec<3> vector_at(const SceneJson& v, const std::string& pointer, const std::string& name) const;

    // --- what the lesson declares ---
    std::string parameter_text(const Parameter& p, const SceneJson& value) const;
    std::string file_path(const Parameter& p, const SceneJson& value) const;
    Runner::Assignments assignments(const SceneJson& object, const std::string& pointer) const;
    std::string stage(const std::string& name, const std::string& pointer) const;
    std::string field(const SceneJson& object, const std::string& pointer) const;
    int component(const SceneJson& object, const std::string& pointer, const std::string& field) const;
    std::vector<Event> events(const SceneJson& list, const std::string& pointer) const;
    Event event(const SceneJson& object, const std::string& pointer) const;
    Pull pull(const SceneJson& object, const std::string& pointer) const;

    // --- version 1 ---
    Camera camera(const SceneJson& object, SceneFile& scene) const;
    SceneView view(const SceneJson& object) const;

    // --- version 2: scene_reader_parts.cpp ---
    void take_parts(const SceneJson& root, SceneFile& scene) const;
    void take_look(const SceneJson& object, SceneView& view) const;
    SceneChanges changes(const SceneJson& object, const std::string& pointer) const;
    // Where the run stands already.
    SceneChanges changes_now(const SceneJson& object, const std::string& pointer) const;
    ScenePlace place(const SceneJson& object, const std::string& pointer) const;
    SceneBeside beside(const SceneJson& object) const;
    ScenePinned pinned(const SceneJson& object) const;
    SceneStops stops(const SceneJson& object) const;
    SceneInspector inspector(const SceneJson& object) const;
    std::vector<SceneNumber> numbers(const SceneJson& list, const std::string& pointer, bool followed) const;
    SceneNumber number(const SceneJson& object, const std::string& pointer, bool followed) const;
    SceneSlide slide(const SceneJson& object) const;
    Guess guess(const SceneJson& object, const std::string& pointer) const;
    SceneLayout layout(const SceneJson& object, std::size_t followed) const;
    void check_plot(const std::string& name, const std::string& pointer, std::size_t followed) const;
    ScenePlots plots(const SceneJson& object, std::size_t followed) const;
    ScenePlot plot(const SceneJson& object, const std::string& pointer, const std::string& name) const;
    SceneKnob knob(const SceneJson& object, const std::string& pointer) const;
    SceneAtlas atlas(const SceneJson& object) const;

    std::string path_;
    PlacedJson json_;
    bool newest_ = false;  // version 2
    mutable std::vector<std::string> notes_;
    std::unique_ptr<Lesson> lesson_;
};

}  // namespace pliant
