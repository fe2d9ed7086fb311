// A scene as one line of text, to be pasted into a chat: "pliant1:" and the scene's JSON, deflated (zlib, RFC 1950) and written
// in the letters of base64url (RFC 4648, section 5) without padding.
#pragma once
#include <pliant/document/scene_file.h>

#include <string>
#include <string_view>

namespace pliant {

inline constexpr std::size_t largest_shared_scene = std::size_t{1} << 20;  // bytes of JSON

// Throws Refused for a scene above largest_shared_scene.
std::string share_text(const SceneFile& scene);

// Blanks and line ends, around the text or inside it, do not count. Throws Refused for another beginning, a newer version, a
// letter that does not belong, a text that is cut off or changed, more than largest_shared_scene, and for all that parse_scene
// refuses.
SceneFile read_share(std::string_view text);

// Begins as a share string of this or another version does.
bool is_share(std::string_view text);

// A share string, or else the path of a scene file.
SceneFile open_scene_text(const std::string& share_or_path);

}  // namespace pliant
