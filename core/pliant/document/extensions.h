// Possibilities for extensions: scenes to open and go on from, each with a question and an answer that is checked. They lie
// beside the lesson as extensions.md, in the format of the walkthrough: a slide each, and in it a
//
//   ```scene     the parameters to open it with, KEY=VALUE words on one or more lines; `show FIELD` colours the picture
//
// from which its actions start. Unlike slides they do not build on each other. The page of the lesson gives each as a share
// string.
#pragma once
#include <pliant/document/scene_file.h>
#include <pliant/document/walkthrough.h>

#include <string>
#include <string_view>
#include <vector>

namespace pliant {

struct Extension {
    SceneFile scene;
    // It alone, from its scene on.
    Walkthrough walkthrough;

    const Slide& slide() const { return walkthrough.slides.front(); }
};

// Throws Refused naming file and line, also for a scene that the lesson refuses.
std::vector<Extension> parse_extensions(const LessonEntry& entry, std::string_view text, std::string_view path);
// Those of a lesson; none when it has no extensions.md.
std::vector<Extension> extensions_of(const LessonEntry& entry);

// Opens the share string of an extension, as a student does, and plays it to its end. Throws as WalkthroughPlayer::next does.
std::vector<ExpectationResult> played(const LessonEntry& entry, const Extension& extension);

}  // namespace pliant
