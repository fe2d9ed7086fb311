#include <pliant/document/share.h>
#include <zlib.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace pliant {
namespace {

constexpr std::string_view share_name = "pliant", share_prefix = "pliant1:", share_blanks = " \t\r\n\v\f";
constexpr std::string_view share_letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr const char* copy_again = "copy the whole share string again";

using Bytes = std::vector<unsigned char>;

std::string to_letters(const Bytes& bytes) {
    std::string text;
    std::uint32_t bits = 0;
    int count = 0;
    for (const unsigned char b : bytes) {
        bits = (bits << 8) | b;
        for (count += 8; count >= 6; count -= 6) text += share_letters[(bits >> (count - 6)) & 63];
    }
    if (count > 0) text += share_letters[(bits << (6 - count)) & 63];
    return text;
}

Bytes from_letters(std::string_view text) {
    Bytes bytes;
    bytes.reserve(text.size() * 3 / 4);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const auto at = share_letters.find(c);
        if (at == std::string_view::npos)
            throw Refused(
                fmt::format("the share string holds the character {}, which is not one of A-Z, a-z, 0-9, - and _: {}",
                            c > ' ' && c < 127 ? fmt::format("'{}'", c) : fmt::format("0x{:02x}", static_cast<unsigned char>(c)),
                            copy_again));
        bits = (bits << 6) | static_cast<std::uint32_t>(at);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<unsigned char>(bits >> count));
    }
    if (count == 6) throw Refused(fmt::format("the share string is cut off: {}", copy_again));
    return bytes;
}

Bytes deflated(std::string_view text) {
    uLongf size = compressBound(static_cast<uLong>(text.size()));
    Bytes bytes(size);
    if (compress2(bytes.data(), &size, reinterpret_cast<const Bytef*>(text.data()), static_cast<uLong>(text.size()),
                  Z_BEST_COMPRESSION) != Z_OK)
        throw std::bad_alloc();
    bytes.resize(size);
    return bytes;
}

[[noreturn]] void cannot_inflate(int reason, const z_stream& stream) {
    if (reason == Z_MEM_ERROR) throw std::bad_alloc();
    if (reason == Z_BUF_ERROR || reason == Z_OK) throw Refused(fmt::format("the share string is cut off: {}", copy_again));
    const std::string_view why = stream.msg ? stream.msg : "a dictionary is asked for";
    throw Refused(why.find("check") != why.npos && why.find("data") != why.npos
                      ? fmt::format("the share string was changed on its way, its checksum does not match: {}", copy_again)
                      : fmt::format("the share string was changed on its way ({}): {}", why, copy_again));
}

std::string inflated(const Bytes& bytes) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> end_later(&stream, inflateEnd);
    Bytes input = bytes;  // zlib takes what it only reads as if it wrote to it
    stream.next_in = input.data(), stream.avail_in = static_cast<uInt>(input.size());
    std::string text;
    std::array<char, 16384> part;
    int result = Z_OK;
    while (result == Z_OK) {
        stream.next_out = reinterpret_cast<Bytef*>(part.data()), stream.avail_out = static_cast<uInt>(part.size());
        result = inflate(&stream, Z_NO_FLUSH);
        text.append(part.data(), part.size() - stream.avail_out);
        if (text.size() > largest_shared_scene)
            throw Refused(
                fmt::format("the share string holds more than {} bytes, the most that a scene may have", largest_shared_scene));
    }
    if (result != Z_STREAM_END) cannot_inflate(result, stream);
    if (stream.avail_in > 0) throw Refused(fmt::format("the share string goes on behind its end: {}", copy_again));
    return text;
}

std::string without_blanks(std::string_view text) {
    std::string rest(text);
    std::erase_if(rest, [](char c) { return share_blanks.find(c) != std::string_view::npos; });
    return rest;
}

// The number in "pliant12:", as it is written.
std::optional<std::string> version_of(std::string_view text) {
    if (!text.starts_with(share_name)) return std::nullopt;
    text.remove_prefix(share_name.size());
    const auto end = text.find_first_not_of("0123456789");
    if (end == 0 || end == std::string_view::npos || text[end] != ':') return std::nullopt;
    return std::string(text.substr(0, end));
}

}  // namespace

bool is_share(std::string_view text) {
    constexpr std::size_t enough = 64;
    return version_of(without_blanks(text.substr(0, enough))).has_value();
}

std::string share_text(const SceneFile& scene) {
    const std::string text = compact_scene_text(scene);
    if (text.size() > largest_shared_scene)
        throw Refused(fmt::format(
            "this scene has {} bytes, a share string holds {}: too much was done in it. Save it as a file, or reset it first",
            text.size(), largest_shared_scene));
    return fmt::format("{}{}", share_prefix, to_letters(deflated(text)));
}

SceneFile read_share(std::string_view given) {
    const std::string text = without_blanks(given);
    const auto version = version_of(text);
    if (!version)
        throw Refused(
            fmt::format("this is no share string, which begins with \"{}\": copy one with File > Copy share string or "
                        "`pliant share`",
                        share_prefix));
    if (!text.starts_with(share_prefix))
        throw Refused(fmt::format("this share string is of version {}, this program reads version 1: update Pliant", *version));
    return parse_scene(inflated(from_letters(std::string_view(text).substr(share_prefix.size()))), "share string");
}

SceneFile open_scene_text(const std::string& share_or_path) {
    return is_share(share_or_path) ? read_share(share_or_path) : read_scene(share_or_path);
}

}  // namespace pliant
