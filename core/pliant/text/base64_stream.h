// Base64 read a part at a time, with padding between parts too, as several texts one behind the other have it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pliant {

class Base64Stream {
public:
    explicit Base64Stream(std::string_view text) : text_(text) {}
    // The next so many bytes; empty where the text ends before, or holds what is no base64. Blanks are skipped.
    std::optional<std::string> read(std::size_t count);

private:
    std::string_view text_;
    std::uint32_t bits_ = 0;
    int count_ = 0;  // of the bits that are left
};

}  // namespace pliant
