// The hash SHA-256 (FIPS 180-4), and bytes as base64 (RFC 4648, section 4).
#pragma once
#include <string>
#include <string_view>

namespace pliant {

// Of the bytes, as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

// With padding.
std::string base64(std::string_view bytes);
// Throws Refused for what is no base64.
std::string from_base64(std::string_view text);

}  // namespace pliant
