// What each fuzzer does with its bytes. Anything but pliant::Error that comes out of here is a fault, and so is a promise of the
// reader that is not kept.
#pragma once
#include <pliant/document/share.h>
#include <pliant/document/walkthrough.h>

#include <stdexcept>
#include <string_view>

namespace pliant::test {

inline void promise(bool kept, const char* what) {
    if (!kept) throw std::logic_error(what);
}

// True when the bytes were accepted.
inline bool fuzz_scene_file(std::string_view bytes) {
    SceneFile scene;
    try {
        scene = parse_scene(bytes, "scene.json");
    } catch (const Error&) {
        return false;
    }
    const std::string text = scene_text(scene);
    promise(scene_text(parse_scene(text, "again.json")) == text,
            "a scene that was read is written so that it reads back the same");
    return true;
}

inline bool fuzz_share_string(std::string_view bytes) {
    SceneFile scene;
    try {
        scene = read_share(bytes);
    } catch (const Error&) {
        return false;
    }
    promise(is_share(share_text(scene)), "a share string begins as one");
    promise(scene_text(read_share(share_text(scene))) == scene_text(scene), "a shared scene reads back the same");
    return true;
}

inline bool fuzz_walkthrough(std::string_view bytes) {
    try {
        promise(!parse_walkthrough(bytes, "walkthrough.md").slides.empty(), "a walkthrough has slides");
    } catch (const Error&) {
        return false;
    }
    return true;
}

}  // namespace pliant::test
