// Files that a person names as the value of a parameter. Each is read once and its bytes are kept, so that a run, what runs
// beside it and what is run again see the same file, whatever becomes of it on the disk. A file is known by a whole number from 1
// on, and 0 is none. Several threads may ask at a time.
#pragma once
#include <pliant/math/types.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

struct StoredFile {
    std::string path;  // from the root on; of a body that comes with Pliant its name alone: "hook_coarse"
    std::string name;  // that readers and messages use, with its ending: "meshes/part.msh", "hook_coarse.msh"
    std::string_view bytes;
    std::string sha256;  // of the bytes
    bool bundled = false;
};

// Does the name end in one of these, in any case of letters?
bool takes_ending(std::string_view name, std::span<const std::string_view> endings);

// The bodies that come with Pliant, which end in one of these (".msh"), by name: "hook_coarse".
std::vector<std::string> bundled_bodies(std::span<const std::string_view> endings);

// ".msh or .vtu, or one of the bodies that come with Pliant: beam_coarse, hook_coarse".
std::string accepted_files(std::span<const std::string_view> endings);

enum class Reading { if_new, again };  // again: where the bytes on the disk are others now, it is another file, of another number

// The number of a file: a path, relative to `folder` (or to where the program was started), or, where no such file is there, the
// name of a body that comes with Pliant, with or without its ending and the folders before it. 0 for "" and "none".
// Throws Refused, without the parameter's name, for what is not there, is no file, ends in none of `endings` or cannot be read,
// with what is accepted.
Index store_file(std::string_view text, std::span<const std::string_view> endings, Reading reading = Reading::if_new,
                 const std::string& folder = "");

// Does a file have this number, and one of these endings? True of 0.
bool is_stored(Index number, std::span<const std::string_view> endings);
// That of 0 has no bytes and no name. Stays where it is while the program runs.
const StoredFile& stored_file(Index number);

}  // namespace pliant
