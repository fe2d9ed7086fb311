// Parameters that are set and have no effect, and what they would need: "F11 is used with path=free".
//
// A lesson says of each parameter when it is used. What it needs is found by trying: the fewest other parameters that have to be
// set to something else, with all the options that do.
#pragma once
#include <pliant/document/scene_file.h>
#include <pliant/document/walkthrough.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// What another parameter has to be: one of these values, as a scene writes them, or any number above or below the one that it is.
struct Need {
    enum class What { one_of, above, below };
    std::string key;
    What what = What::one_of;
    std::vector<std::string> values;
    std::string text() const;  // "path=free", "scheme=jacobi or multigrid", "friction above 0"
};
// Ways in which a parameter would be used, each a list of needs that go together. None where nothing was found.
using Ways = std::vector<std::vector<Need>>;
// "path=free and dimension=2, or with start=random"; "" for none.
std::string text_of(const Ways& ways);

// What the parameter of this key would need, the others being as in `assignments`; none when it is used. Throws Refused for what
// the lesson does not know.
Ways ways_to_use(const LessonEntry& entry, const Runner::Assignments& assignments, std::string_view key);

struct UnusedSetting {
    std::string key, needs;
    std::string place{};  // "path:line" of a text where it is set; "" for none
    // "F11 is used with path=free: here it has no effect".
    std::string text() const;
};

// Follows what a run sets, without running it.
class UsedSettings {
public:
    explicit UsedSettings(const LessonEntry& entry);
    ~UsedSettings();

    // The keys are followed from now on. Throws Refused for what the lesson does not know.
    void set(const Runner::Assignments& assignments, const std::string& place = "");
    // All parameters are as they are at first; what is followed stays.
    void load_defaults();
    // The run goes on with what is set.
    void look();
    // What was set and never used, in the order in which it was set.
    std::vector<UnusedSetting> unused() const;

private:
    struct Followed {
        Parameter* parameter;
        std::string place;
        bool used;
    };
    std::unique_ptr<Lesson> lesson_;
    std::vector<Followed> followed_;
};

// What a scene sets, at its start or in its events, and does not use from then on.
std::vector<UnusedSetting> unused_settings(const SceneFile& scene);
// The same of the actions of a walkthrough, from its first slide to its last.
std::vector<UnusedSetting> unused_settings(const LessonEntry& entry, const Walkthrough& walkthrough);

}  // namespace pliant
