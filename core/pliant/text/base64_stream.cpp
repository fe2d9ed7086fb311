#include <pliant/text/base64_stream.h>

#include <array>

namespace pliant {
namespace {

// The six bits of each letter; −1 of what is none.
constexpr std::array<int, 256> six_bits = [] {
    std::array<int, 256> table{};
    table.fill(-1);
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t k = 0; k < letters.size(); ++k) table[static_cast<unsigned char>(letters[k])] = static_cast<int>(k);
    return table;
}();

}  // namespace

std::optional<std::string> Base64Stream::read(std::size_t count) {
    std::string bytes;
    while (bytes.size() < count) {
        if (text_.empty()) return std::nullopt;
        const auto c = static_cast<unsigned char>(text_.front());
        text_.remove_prefix(1);
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        if (c == '=') {  // a text ends, and another may begin
            bits_ = 0, count_ = 0;
            continue;
        }
        if (six_bits[c] < 0) return std::nullopt;
        bits_ = bits_ << 6 | static_cast<std::uint32_t>(six_bits[c]);
        if ((count_ += 6) < 8) continue;
        count_ -= 8;
        bytes += static_cast<char>(bits_ >> count_ & 0xff);
    }
    return bytes;
}

}  // namespace pliant
