// The bytes of a mesh file, read from front to back: numbers as text or as they lie in memory. All throw Refused as
// "part.msh:12: …", or with the byte where the file is binary.
#pragma once
#include <pliant/mesh_file/mesh_file.h>

#include <cstdint>
#include <cstring>
#include <optional>

namespace pliant {

class MeshSource {
public:
    MeshSource(std::string_view bytes, std::string_view path) : bytes_(bytes), path_(path) {}

    // Numbers from here on: as text, or binary, with their bytes turned round where the file comes from a machine of the other
    // kind.
    void be_binary(bool swapped) { binary_ = true, swapped_ = swapped; }
    void be_text() { binary_ = false; }
    bool binary() const { return binary_; }

    [[noreturn]] void refuse(std::string_view what) const;
    // What stands somewhere, short and clean enough for a message.
    static std::string printable(std::string_view text);

    // --- text, in binary files as well ---
    bool at_end() const { return place_ >= bytes_.size(); }
    // Up to the next end of line, without spaces around it.
    std::string_view line();
    // The same, and stays before it.
    std::string_view peek_line() const;
    // Up to the next space.
    std::string_view word();
    // The same, and stays before it; empty at the end.
    std::optional<std::string_view> peek_word();
    Real real_word();
    Index whole_word();
    // The rest of a line behind the words read so far, "in quotes".
    std::string_view quoted();
    // Leaves everything up to and with a line that reads `end`.
    void skip_past(std::string_view end);
    // The next line with something on it must be this.
    void expect(std::string_view text);

    // --- numbers of either kind ---
    std::int32_t whole();  // 4 bytes
    FileNumber number();   // 8 bytes
    Real real();           // 8 bytes
    // Binary: of 1, 2, 4 or 8 bytes, with fraction or whole, as a Real.
    Real number_of(std::size_t bytes, bool is_real, bool is_signed);
    void skip(std::size_t bytes);
    // How many of something follow, each of at least so many bytes: refused when the file is too short for them.
    Index count(std::string_view what, std::size_t least_bytes_each);
    Index count_of_ints(std::string_view what, std::size_t least_bytes_each);
    Index checked_count(Index count, std::string_view what, std::size_t least_bytes_each) const;

private:
    template <class T>
    T raw();
    template <class T>
    Real raw_real();
    void skip_space();

    std::string_view bytes_, path_;
    std::size_t place_ = 0;
    bool binary_ = false, swapped_ = false;
};

}  // namespace pliant
